(* Scenes of the format taut-scene/1 (docs/scenes.md), for the checker. What it does not cover is refused, by name. *)
open Taut_check
open Exact

exception Not_covered of string
let not_covered what = raise (Not_covered what)

let number where v = Numbers.of_float (Json.float where v)
let numbers where v = List.map (number where) (Json.list where v)
let point where v =
  let x, y = Json.pair where v in
  (number where x, number where y)

(* Shapes *)

let ring where v =
  match Json.list where v with
  | _ :: _ :: _ :: _ as vertices -> List.map (point where) vertices
  | _ -> Json.error where "a polygon has at least three vertices"

(* The heights that a part reaches through; without an end, infinite. *)
let layers where v =
  match Json.pair where v with
  | lo, hi ->
      let height otherwise = function Json.Null -> otherwise | v -> Json.float where v in
      let lo = height neg_infinity lo and hi = height infinity hi in
      if lo < hi then (lo, hi) else Json.error where "the layers are not two heights, the lower one first"

(* One polygon, with its own layers, or those of the body. *)
let polygon where z v =
  match v with
  | Json.List _ -> ([ ring where v ], z)
  | Json.Object m ->
      List.iter (fun key -> if Json.find m key <> None then not_covered (where ^ ": a polygon as \"" ^ key ^ "\""))
        [ "path"; "wkt"; "geojson" ];
      let m = Json.members where [ "outline"; "holes"; "z" ] v in
      let holes = match Json.find m "holes" with None -> [] | Some h -> List.map (ring where) (Json.list where h) in
      let z = match Json.find m "z" with None -> z | Some z -> layers where z in
      (ring where (Json.get where m "outline") :: holes, z)
  | _ -> Json.error where "expected a polygon"

let shape where m =
  let z = match Json.find m "z" with None -> (neg_infinity, infinity) | Some z -> layers where z in
  match (Json.find m "polygon", Json.find m "parts") with
  | Some p, None -> [ polygon where z p ]
  | None, Some parts -> List.map (polygon where z) (Json.list where parts)
  | _ -> Json.error where "expected either \"polygon\" or \"parts\""

(* A body is one body for each interval of heights that has the same parts throughout, from the lowest one up. *)
let cross_sections parts =
  let heights = List.sort_uniq compare (List.concat_map (fun (_, (lo, hi)) -> [ lo; hi ]) parts) in
  let rec intervals = function a :: (b :: _ as rest) -> (a, b) :: intervals rest | _ -> [] in
  let within (a, b) = List.filter (fun (_, (lo, hi)) -> lo <= a && b <= hi) parts in
  let sections = List.map (fun interval -> (interval, within interval)) (intervals heights) in
  let rec joined = function
    | ((a, _), p) :: ((_, c), q) :: rest when p == q || p = q -> joined (((a, c), p) :: rest)
    | section :: rest -> section :: joined rest
    | [] -> [] in
  List.map (fun (interval, parts) -> (interval, List.map fst parts)) (List.filter (fun (_, p) -> p <> []) (joined sections))

(* Motions *)

let zero = Numbers.zero
let is_zero a = Z.equal a.mantissa Z.zero

(* A pivot matters only where something turns. *)
let piece ?(until = zero) ?(origin = zero) ?(turn = Fixed) ?(pivot = (zero, zero)) ?orbit x y =
  let pivot = if turn = Fixed && orbit = None then (zero, zero) else pivot in
  { until; origin; shift = (x, y); turn; pivot; orbit }

let rotation where v =
  match v with
  | Json.Null -> Fixed
  | Json.Object [ ("angle", a) ] -> Angle (numbers where a)
  | Json.Object [ ("half_angle_tangent", s) ] -> HalfAngleTangent (numbers where s)
  | Json.Object [ ("direction", d) ] ->
      let m = Json.members where [ "a"; "b" ] d in
      Direction (numbers where (Json.get where m "a"), numbers where (Json.get where m "b"))
  | Json.Object [ ("cosine", a) ] -> Cosine (numbers where a)
  | _ -> Json.error where "unknown rotation"

let piece_keys = [ "x"; "y"; "rotation"; "until"; "pivot"; "origin"; "orbit" ]
let optional m key read default = match Json.find m key with None -> default | Some v -> read v

let read_piece where v =
  let m = Json.members where piece_keys v in
  let orbit = optional m "orbit" (fun o ->
    let o = Json.members where [ "center"; "angle" ] o in
    Some (point where (Json.get where o "center"), numbers where (Json.get where o "angle"))) None in
  piece ~until:(optional m "until" (number where) zero) ~origin:(optional m "origin" (number where) zero)
    ~turn:(optional m "rotation" (rotation where) Fixed) ~pivot:(optional m "pivot" (point where) (zero, zero)) ?orbit
    (optional m "x" (numbers where) []) (optional m "y" (numbers where) [])

let rounded q = Numbers.nearest_double q
let rational = Numbers.to_rational
let constant a = if is_zero a then [] else [ a ]

(* The line through (t0, a) and (t1, b), times a factor, in powers of the time since t0. *)
let line t0 a t1 b factor =
  let product = Q.mul (rational a) factor in
  if a = b then constant (rounded product)
  else
    let slope = Q.div (Q.sub (rational b) (rational a)) (Q.sub (rational t1) (rational t0)) in
    [ rounded product; rounded (Q.mul slope factor) ]

(* Held at an angle in degrees: quarter turns are exact. *)
let held degrees =
  let q = Q.div (rational degrees) (Q.of_int 90) in
  if Z.equal (Q.den q) Z.one then
    match Z.to_int (Z.erem (Q.num q) (Z.of_int 4)) with
    | 0 -> Fixed
    | k ->
        let c, s = List.nth [ (1, 0); (0, 1); (-1, 0); (0, -1) ] k in
        Direction ([ Numbers.of_int c ], [ Numbers.of_int s ])
  else Angle [ rounded (Q.mul (rational degrees) Numbers.radians_per_degree) ]

(* How a body comes to a keyframe: around a centre, by an angle in degrees, turning with the way or not. *)
type way = Straight | Around of { centre : number * number; by : number; turns : bool }
type keyframe = { t : number; x : number; y : number; degrees : number; way : way }

(* And which of x, y and the angle it has, which must be the same ones in all keyframes. *)
let keyframe where v =
  let m = Json.members where [ "t"; "x"; "y"; "angle_deg"; "turn"; "arc" ] v in
  let t = number where (Json.get where m "t") in
  let around turns v =
    let m = Json.members where [ "center"; "deg" ] v in
    Around { centre = point where (Json.get where m "center"); by = number where (Json.get where m "deg"); turns } in
  let one key = optional m key (number where) zero in
  let given = List.map (fun key -> Json.find m key <> None) [ "x"; "y"; "angle_deg" ] in
  let way = match (Json.find m "turn", Json.find m "arc") with
    | None, None -> Straight
    | Some v, None when not (List.mem true given) -> around true v
    | None, Some v when not (List.mem true given) -> around false v
    | _ -> Json.error where "a keyframe around a centre has no other place" in
  ({ t; x = one "x"; y = one "y"; degrees = one "angle_deg"; way }, if way = Straight then Some given else None)

(* Of an angle in degrees. *)
let cos_sin degrees =
  let turns = Q.div degrees (Q.of_int 360) in
  let rest = Q.mul (Q.sub turns (Q.of_bigint (Q.to_bigint turns))) (Q.of_int 360) in
  let quarters = Q.div rest (Q.of_int 90) in
  if Z.equal (Q.den quarters) Z.one then
    let c, s = List.nth [ (1, 0); (0, 1); (-1, 0); (0, -1) ] (Z.to_int (Z.erem (Q.num quarters) (Z.of_int 4))) in
    (Q.of_int c, Q.of_int s)
  else Numbers.cos_sin (Q.mul rest Numbers.radians_per_degree)

(* Where the way around a centre leads to; each number is rounded once. *)
let take_way (px, py) before k =
  match k.way with
  | Straight -> k
  | Around { centre = (cx, cy); by; turns } ->
      let c, s = cos_sin (rational by) in
      let q = rational in
      let x = Q.sub (Q.add (q px) (q before.x)) (q cx) and y = Q.sub (Q.add (q py) (q before.y)) (q cy) in
      (* A sum that is 0 is left with an error of the sine: smaller sums than that count as 0. *)
      let noise = Q.mul (List.fold_left (fun n a -> Q.add n (Q.abs a)) Q.zero [ x; y; q cx; q cy; q px; q py ])
        (Q.make Z.one (Z.shift_left Z.one 900)) in
      let coordinate sum = if Q.lt (Q.abs sum) noise then zero else rounded sum in
      { k with
        x = coordinate (Q.sub (Q.add (Q.sub (Q.mul c x) (Q.mul s y)) (q cx)) (q px));
        y = coordinate (Q.sub (Q.add (Q.add (Q.mul s x) (Q.mul c y)) (q cy)) (q py));
        degrees = (if turns then rounded (Q.add (q before.degrees) (q by)) else before.degrees) }

let rest_at pivot until k = piece ~until ~turn:(held k.degrees) ~pivot (constant k.x) (constant k.y)

let angles a b = Angle (line a.t a.degrees b.t b.degrees Numbers.radians_per_degree)

let between pivot a b =
  match b.way with
  | Around { centre; by; turns } when not (is_zero by) ->
      let turn = if turns && a.degrees <> b.degrees then angles a b else held a.degrees in
      let angle = line a.t zero b.t by Numbers.radians_per_degree in
      piece ~until:b.t ~origin:a.t ~turn ~pivot ~orbit:(centre, angle) (constant a.x) (constant a.y)
  | _ ->
      let x = line a.t a.x b.t b.x Q.one and y = line a.t a.y b.t b.y Q.one in
      let turn = if a.degrees = b.degrees then held a.degrees else angles a b in
      let varies = List.length x > 1 || List.length y > 1 || (match turn with Angle (_ :: _ :: _) -> true | _ -> false) in
      piece ~until:b.t ~origin:(if varies then a.t else zero) ~turn ~pivot x y

let from_keyframes where pivot given =
  (match List.filter_map snd given with
   | first :: rest -> if List.exists (fun g -> g <> first) rest then Json.error where "keyframes have different keys"
   | [] -> ());
  match List.map fst given with
  | [] -> Json.error where "there are no keyframes"
  | first :: rest ->
      if first.way <> Straight then Json.error where "the first keyframe goes around a centre";
      let frames = List.rev (List.fold_left (fun done_ k ->
        let before = List.hd done_ in
        if not (Q.lt (rational before.t) (rational k.t)) then Json.error where "keyframes are not in order of time";
        take_way pivot before k :: done_) [ first ] rest) in
      let rec pieces = function
        | a :: (b :: _ as frames) -> between pivot a b :: pieces frames
        | [ last ] -> if rest = [] then [] else [ rest_at pivot zero last ]
        | [] -> [] in
      rest_at pivot (if rest = [] then zero else first.t) first :: pieces frames

let from_velocity where m =
  let vx, vy = optional m "velocity" (point where) (zero, zero) in
  let spin = optional m "spin_deg" (number where) zero in
  let coefficients v = if is_zero v then [] else [ zero; v ] in
  let turn = if is_zero spin then Fixed
    else Angle [ zero; rounded (Q.mul (rational spin) Numbers.radians_per_degree) ] in
  [ piece ~turn ~pivot:(optional m "pivot" (point where) (zero, zero)) (coefficients vx) (coefficients vy) ]

let from_sweep where start stop v =
  let m = Json.members where [ "pivot"; "from_deg"; "to_deg" ] v in
  if not (Q.lt (rational start) (rational stop)) then Json.error where "a sweep, and the time has no length";
  let angle key = number where (Json.get where m key) in
  [ piece ~origin:start ~pivot:(optional m "pivot" (point where) (zero, zero))
      ~turn:(Angle (line start (angle "from_deg") stop (angle "to_deg") Numbers.radians_per_degree)) [] [] ]

let rec ascending where = function
  | a :: (_ :: rest_of as rest) ->
      (match rest_of with
       | _ :: _ ->
           let b = List.hd rest in
           if not (Q.lt (rational a.until) (rational b.until)) then Json.error where "pieces are not in order of time"
       | [] -> ());
      ascending where rest
  | _ -> ()

let read_motion where start stop v =
  match v with
  | Json.Null -> []
  | Json.List pieces ->
      let n = List.length pieces in
      if n = 0 then Json.error where "no pieces";
      let motion = List.mapi (fun i p ->
        (match p with
         | Json.Object m when i + 1 < n && Json.find m "until" = None -> Json.error where "a piece without \"until\""
         | _ -> ());
        read_piece where p) pieces in
      ascending where motion; motion
  | Json.Object m ->
      let has key = Json.find m key <> None in
      if has "csv" then not_covered (where ^ ": keyframes from a file");
      if has "keyframes" then
        let m = Json.members where [ "keyframes"; "pivot" ] v in
        from_keyframes where (optional m "pivot" (point where) (zero, zero))
          (List.map (keyframe where) (Json.list where (Json.get where m "keyframes")))
      else if has "sweep" then from_sweep where start stop (Json.get where (Json.members where [ "sweep" ] v) "sweep")
      else if has "velocity" || has "spin_deg" then from_velocity where (Json.members where [ "velocity"; "spin_deg"; "pivot" ] v)
      else [ read_piece where v ]
  | _ -> Json.error where "expected a motion"

let rests motion = List.for_all (fun p -> p.shift = ([], []) && p.turn = Fixed && p.orbit = None) motion

(* Scenes *)

type named = {
  name : string; parent : string option; own : piece list;
  parts : ((number * number) list list * (float * float)) list }

let read_body start stop i v =
  let where = Printf.sprintf "bodies[%d]" i in
  let m = Json.members where [ "name"; "polygon"; "parts"; "z"; "motion"; "relative_to"; "id" ] v in
  { name = Json.string where (Json.get where m "name");
    parent = optional m "relative_to" (fun v -> Some (Json.string where v)) None;
    own = optional m "motion" (read_motion where start stop) [];
    parts = shape where m }

(* From the outermost parent down, without motions that rest. *)
let chain bodies body =
  let rec go depth body below =
    if depth > 16 then Json.error body.name "a chain of parents without an end";
    let below = if rests body.own then below else body.own :: below in
    match body.parent with
    | None -> below
    | Some name ->
        (match List.find_opt (fun b -> b.name = name) bodies with
         | None -> Json.error body.name ("no body is called \"" ^ name ^ "\"")
         | Some parent -> go (depth + 1) parent below) in
  go 1 body []

let read text =
  let v = Json.parse text in
  (match v with
   | Json.Object m ->
       List.iter (fun (key, what) -> if Json.find m key <> None then not_covered what)
         [ ("joints", "joints instead of a time"); ("mechanism", "a mechanism") ]
   | _ -> ());
  (* An exact log says nothing of distances: "clearances" means nothing here. *)
  let m = Json.members "scene" [ "format"; "time"; "bodies"; "ignore"; "clearances"; "at_rest"; "id"; "$schema" ] v in
  if Json.get "scene" m "format" <> Json.String "taut-scene/1" then Json.error "format" "expected \"taut-scene/1\"";
  let start, stop = point "time" (Json.get "scene" m "time") in
  if Q.lt (rational stop) (rational start) then Json.error "time" "the end is before the start";
  let bodies = List.mapi (read_body start stop) (Json.list "bodies" (Json.get "scene" m "bodies")) in
  let names = List.map (fun b -> b.name) bodies in
  if List.length (List.sort_uniq compare names) < List.length names then Json.error "bodies" "two bodies have one name";
  let index name =
    let rec go i = function [] -> Json.error "ignore" ("no body is called \"" ^ name ^ "\"") | n :: l -> if n = name then i else go (i + 1) l in
    go 0 names in
  let pairs = optional m "ignore" (Json.list "ignore") [] in
  let everything = List.init (List.length bodies) Fun.id in
  let alone = ref [] in
  let ignored = List.concat_map (fun p ->
    match Json.pair "ignore" p with
    | Json.String "*", Json.String "*" -> alone := everything; List.concat_map (fun i -> List.map (fun j -> (i, j)) everything) everything
    | Json.String "*", Json.String a | Json.String a, Json.String "*" ->
        alone := index a :: !alone;
        List.map (fun j -> (index a, j)) everything
    | Json.String a, Json.String b -> [ (index a, index b) ]
    | _ -> Json.error "ignore" "expected names") pairs in
  let chains = List.map (chain bodies) bodies in
  (* If nothing moves against anything else, of what is not ignored altogether, all pairs are tested. *)
  let others = List.filteri (fun i _ -> not (List.mem i !alone)) chains in
  let alike = match others with [] -> true | c :: rest -> List.for_all (fun d -> d = c) rest in
  let at_rest =
    match Json.find m "at_rest" with
    | None | Some (Json.String "skip") -> alike
    | Some (Json.String "test") -> true
    | _ -> Json.error "at_rest" "expected \"test\" or \"skip\"" in
  (* The lowest cross-section of each body has its number, the others follow after the last body. *)
  let sections = List.map2 (fun (i, chain) b -> List.map (fun (z, parts) -> (i, z, { chain; shape = parts })) (cross_sections b.parts))
    (List.mapi (fun i c -> (i, c)) chains) bodies in
  let all = List.map List.hd sections @ List.concat_map List.tl sections in
  let layered = List.length all > List.length bodies || List.exists (fun (_, z, _) -> z <> (neg_infinity, infinity)) all in
  let ignored =
    if not layered then ignored
    else
      let apart (i, (lo, hi), _) (j, (lo', hi'), _) =
        i = j || List.mem (i, j) ignored || List.mem (j, i) ignored || Float.max lo lo' >= Float.min hi hi' in
      List.concat (List.mapi (fun k x ->
        List.concat (List.mapi (fun l y -> if k < l && apart x y then [ (k, l) ] else []) all)) all) in
  ( { start; stop; bodies = List.map (fun (_, _, b) -> b) all; ignored; at_rest },
    Array.of_list (List.map (fun (i, _, _) -> List.nth names i) all) )
