(** The checker: a function from a scene and a log to a verdict. Soundness.v proves what [true] means. *)

From Coq Require Import ZArith List Bool PeanoNat.
From Taut Require Import Definitions Numbers Models Functions Placement Outlines Whole Lines.
Import ListNotations.

(** * Logs *)

(** How two ranges of edges are separated throughout a window: by a direction, with a level between them (a polynomial in the
    time from the window's middle); or halves of the first or of the second range are. *)
Inductive separation :=
| Line (direction : number * number) (level : list number)
| FirstHalves (s1 s2 : separation)
| SecondHalves (s1 s2 : separation).

Record window := Window { opens : number; closes : number; how : separation }.

(** Windows of each tested pair, in the order of the smaller, then the larger index. *)
Record log := Log { proved_until : number; pairs : list ((nat * nat) * list window) }.

(** * Separations *)

Definition positive (r : number) (M : model) : bool := below (slack M) (lower r (poly_of M)).

(** Along a direction, from a level on: a vertex (x, y) is at [base] + x [per_x] + y [per_y]. *)
Record projection := Projection { base : model; per_x : model; per_y : model }.
Definition project (r : number) (n : number * number) (level : poly) (P : placement) : projection :=
  Projection (msub (madd (mscale (fst n) (ox P)) (mscale (snd n) (oy P))) (Model level zero))
             (madd (mscale (fst n) (co P)) (mscale (snd n) (si P)))
             (msub (mscale (snd n) (co P)) (mscale (fst n) (si P))).
Definition along_direction (J : projection) (v : vertex) : model :=
  madd (base J) (madd (mscale (fst v) (per_x J)) (mscale (snd v) (per_y J))).
Fixpoint exactly_beyond (r : number) (J : projection) (t : tree) : bool :=
  match t with
  | Empty => true
  | Leaf e _ _ _ => positive r (along_direction J (fst e)) && positive r (along_direction J (snd e))
  | Node _ t1 t2 => exactly_beyond r J t1 && exactly_beyond r J t2
  end.

(** Where a body is in a window. *)
Record side := Side { grid_of : Z; place_in : placement; whole_in : whole_placement }.
Definition side_of (g : Z) (s : number) (P : placement) : side := Side g P (whole_of g s P).
(** Half of a window's length, and not less than that in few bits. *)
Definition radius (opens closes : number) : number := half (sub closes opens).
(** Where a chain puts a body in a window, and whether its pieces hold at the window's end, too. *)
Definition placed_in (g : Z) (c : list motion) (opens closes : number) : option (side * bool) :=
  let r := radius opens closes in
  match chain_model opens closes (half (add opens closes)) r c with
  | None => None
  | Some (P, closed) => Some (side_of g (round_up r) P, closed)
  end.

Definition number_eq (a b : number) : {a = b} + {a <> b}.
Proof. decide equality; apply Z.eq_dec. Defined.

(** The edges of a body, on a grid of 2^[grid]; and where it is in the longest window, which many pairs have. *)
Record outline := Outline { grid : Z; tree_in : tree; from : number; to : number; throughout : option (side * bool) }.
Definition placed_outline (o : outline) (whole_chain : bool) (c : list motion) (opens closes : number) : option (side * bool) :=
  if whole_chain && (if number_eq opens (from o) then true else false) && (if number_eq closes (to o) then true else false)
  then throughout o else placed_in (grid o) c opens closes.


(** Whether edges are beyond a level for |h| <= r: first in whole numbers, in terms of h / s, where r <= s. *)
Definition beyond (r s : number) (n : number * number) (level : poly) (S : side) (t : tree) : bool :=
  tree_beyond (whole_line_of (grid_of S) s n level (whole_in S) (box_of t)) t || exactly_beyond r (project r n level (place_in S)) t.

Fixpoint separated (r s : number) (A B : side) (E F : tree) (how : separation) : bool :=
  match how with
  | Line n level => beyond r s (neg (fst n), neg (snd n)) (pneg level) A E && beyond r s n level B F
  | FirstHalves s1 s2 => let (E1, E2) := halves E in separated r s A B E1 F s1 && separated r s A B E2 F s2
  | SecondHalves s1 s2 => let (F1, F2) := halves F in separated r s A B E F1 s1 && separated r s A B E F2 s2
  end.

(** * A point of each ring outside of the other body, in the middle of the window *)

Definition spot := (model * model)%type.
Definition place_vertex (P : placement) (v : vertex) : spot :=
  (madd (ox P) (msub (mscale (fst v) (co P)) (mscale (snd v) (si P))),
   madd (oy P) (madd (mscale (fst v) (si P)) (mscale (snd v) (co P)))).

Definition sign (M : model) : option bool :=
  if positive zero M then Some true else if positive zero (mneg M) then Some false else None.

(** Whether the ray from w to the right crosses the edge from u to v, where that is certain. *)
Definition crosses_spot (w u v : spot) : option bool :=
  let uy := msub (snd u) (snd w) in let vy := msub (snd v) (snd w) in
  match sign uy, sign vy with
  | Some a, Some b =>
      if Bool.eqb a b then Some false
      else
        let ux := msub (fst u) (fst w) in let vx := msub (fst v) (fst w) in
        match sign (msub (mmul zero ux vy) (mmul zero vx uy)) with
        | Some c => Some (Bool.eqb b c)
        | None => None
        end
  | _, _ => None
  end.

Fixpoint odd_spot (w : spot) (l : list (spot * spot)) : option bool :=
  match l with
  | [] => Some false
  | e :: l => match crosses_spot w (fst e) (snd e), odd_spot w l with
              | Some c, Some o => Some (xorb c o)
              | _, _ => None
              end
  end.

(** Points of an edge that are tried: neither of them is likely to be at the height of a vertex. *)
Definition fractions : list number := [Number 391 (-10); Number 633 (-10)].
Definition spot_between (k : number) (u v : spot) : spot :=
  (madd (fst u) (mscale k (msub (fst v) (fst u))), madd (snd u) (mscale k (msub (snd v) (snd u)))).

Definition spots (P : placement) (e : vertex * vertex) : spot * spot := (place_vertex P (fst e), place_vertex P (snd e)).
(** All edges of a part, each vertex placed once. *)
Definition placed_edges (P : placement) (p : list (list vertex)) : list (spot * spot) :=
  flat_map (fun r => edges (map (place_vertex P) r)) p.

Definition ring_outside (P : placement) (r : list vertex) (others : list (list (spot * spot))) : bool :=
  match r with
  | [] => true
  | _ => forallb (fun other =>
           existsb (fun e => let (u, v) := spots P e in
             existsb (fun k => match odd_spot (spot_between k u v) other with Some false => true | _ => false end) fractions)
             (edges r)) others
  end.

Definition all_edges_of (p : list (list vertex)) : list (vertex * vertex) := flat_map edges p.

Definition outside (P Q : placement) (s t : list (list (list vertex))) : bool :=
  let others := map (placed_edges Q) t in
  forallb (fun p => forallb (fun r => ring_outside P r others) p) s.

(** * Windows *)

Definition is_line (s : separation) : bool := match s with Line _ _ => true | _ => false end.
Definition edges_of (b : body) : list (vertex * vertex) := flat_map all_edges_of (shape b).
Definition outline_of (from to : number) (b : body) : outline :=
  let e := edges_of b in
  let highest (v : vertex) := Z.max (magnitude (fst v)) (magnitude (snd v)) in
  let g := (fold_right (fun (e : edge) m => Z.max (highest (fst e)) m) (-1000) e - vertex_bits)%Z in
  Outline g (tree_of (length e) g e) from to (placed_in g (chain b) from to).

(** Whether all edges of two bodies are separated throughout a window; and whether its pieces hold at its end, too. *)
Definition check_window (place_a place_b : number -> number -> option (side * bool)) (ta tb : tree) (w : window) : option bool :=
  let r := radius (opens w) (closes w) in
  if at_most zero r then
    match place_a (opens w) (closes w), place_b (opens w) (closes w) with
    | Some (A, closed), Some (B, closed') =>
        if separated r (round_up r) A B ta tb (how w) then Some (closed && closed') else None
    | _, _ => None
    end
  else None.

(** Whether all rings are outside of the other body in a window: on the other side of a line, or so in its middle. *)
Definition outside_in_window (ca cb : list motion) (a b : body) (w : window) : bool :=
  is_line (how w) ||
  let middle := half (add (opens w) (closes w)) in
  match chain_model (opens w) (closes w) middle zero ca, chain_model (opens w) (closes w) middle zero cb with
  | Some (P, _), Some (Q, _) => outside P Q (shape a) (shape b) && outside Q P (shape b) (shape a)
  | _, _ => false
  end.

(** Windows without a gap, from a time to another one. If all rings are known to be outside at the time, then also in a
    window that holds there. *)
Fixpoint check_windows (check : window -> option bool) (outside : window -> bool) (time : number) (known : bool) (stop : number)
  (l : list window) : bool :=
  match l with
  | [] => false
  | w :: rest =>
      at_most (opens w) time &&
      match check w with
      | None => false
      | Some closed =>
          (known && at_most time (closes w) && (closed || below time (closes w)) || outside w) &&
          (at_most stop (closes w) && (closed || below stop (closes w)) || check_windows check outside (closes w) closed stop rest)
      end
  end.

(** * Pairs *)

Definition rotation_eq (a b : rotation) : {a = b} + {a <> b}.
Proof. decide equality; apply (list_eq_dec number_eq). Defined.
Definition pair_eq {A B} (ea : forall a b : A, {a = b} + {a <> b}) (eb : forall a b : B, {a = b} + {a <> b}) (p q : A * B) :
  {p = q} + {p <> q}.
Proof. decide equality. Defined.
Definition piece_eq (a b : piece) : {a = b} + {a <> b}.
Proof.
  pose proof number_eq. pose proof (list_eq_dec number_eq). pose proof (pair_eq number_eq number_eq).
  decide equality; [decide equality|apply rotation_eq|]; apply pair_eq; auto.
Defined.
Definition motion_eq : forall a b : motion, {a = b} + {a <> b} := list_eq_dec piece_eq.
Definition chain_eq : forall a b : list motion, {a = b} + {a <> b} := list_eq_dec motion_eq.

(** What two chains do not have in common: seen from their last common ancestor. *)
Fixpoint without_common (c d : list motion) : list motion * list motion :=
  match c, d with
  | m :: c', n :: d' => if regular m then (if motion_eq m n then without_common c' d' else (c, d)) else (c, d)
  | _, _ => (c, d)
  end.

Definition same_length {A} (l m : list A) : bool := Nat.eqb (length l) (length m).
Definition is_pair (i j : nat) (p : nat * nat) : bool := Nat.eqb (fst p) i && Nat.eqb (snd p) j.
Definition is_tested (s : scene) (i j : nat) (a b : body) : bool :=
  negb (existsb (fun p => is_pair i j p || is_pair j i p) (ignored s)) &&
  (at_rest s || (if chain_eq (chain a) (chain b) then false else true)).

Definition numbered := (nat * (body * outline))%type.

(** Takes the windows of one pair from the log. *)
Definition check_pair (s : scene) (stop : number) (x y : numbered) (l : list ((nat * nat) * list window)) :
  option (list ((nat * nat) * list window)) :=
  let (i, p) := x in let (a, ea) := p in
  let (j, q) := y in let (b, eb) := q in
  if is_tested s i j a b then
    match l with
    | [] => None
    | (ij, windows) :: rest =>
        let (ca, cb) := without_common (chain a) (chain b) in
        if is_pair i j ij && 
           check_windows (check_window (placed_outline ea (same_length ca (chain a)) ca) (placed_outline eb (same_length cb (chain b)) cb)
                            (tree_in ea) (tree_in eb))
             (outside_in_window ca cb a b) (start s) false stop windows
        then Some rest else None
    end
  else Some l.

Fixpoint check_row (s : scene) (stop : number) (x : numbered) (ys : list numbered) (l : list ((nat * nat) * list window)) :=
  match ys with
  | [] => Some l
  | y :: ys => match check_pair s stop x y l with None => None | Some l => check_row s stop x ys l end
  end.
Fixpoint check_rows (s : scene) (stop : number) (xs : list numbered) (l : list ((nat * nat) * list window)) :=
  match xs with
  | [] => Some l
  | x :: xs => match check_row s stop x xs l with None => None | Some l => check_rows s stop xs l end
  end.

Fixpoint number_bodies (from to : number) (i : nat) (l : list body) : list numbered :=
  match l with [] => [] | b :: l => (i, (b, outline_of from to b)) :: number_bodies from to (S i) l end.

Definition check (s : scene) (l : log) : bool :=
  match check_rows s (proved_until l) (number_bodies (start s) (proved_until l) 0 (bodies s)) (pairs l) with Some [] => true | _ => false end.
