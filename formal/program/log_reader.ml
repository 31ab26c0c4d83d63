(* Exact logs (docs/exact-logs.md). *)
open Taut_check

let number = Scene_reader.number

(* Logs may be long: not by recursion. *)
let map f l = List.rev (List.rev_map f l)

(* In preorder: 1 and 2 halve the first and the second range of edges, a line ends a branch. *)
let rec separation = function
  | Json.Number 1. :: rest -> let a, rest = separation rest in let b, rest = separation rest in (FirstHalves (a, b), rest)
  | Json.Number 2. :: rest -> let a, rest = separation rest in let b, rest = separation rest in (SecondHalves (a, b), rest)
  | Json.List (x :: y :: level) :: rest ->
      (Line ((number "direction" x, number "direction" y), List.map (number "level") level), rest)
  | _ -> Json.error "windows" "expected 1, 2, or a direction and a level"

let window v =
  match v with
  | Json.List (a :: b :: how) ->
      (match separation how with
       | how, [] -> { opens = number "windows" a; closes = number "windows" b; how }
       | _ -> Json.error "windows" "something after the separation")
  | _ -> Json.error "windows" "expected [from, to, separation...]"

let index v =
  let x = Json.float "pair" v in
  if Float.is_integer x && x >= 0. && x < 1e9 then int_of_float x else Json.error "pair" "expected an index"

let read text =
  let m = Json.members "log" [ "format"; "until"; "pairs" ] (Json.parse text) in
  if Json.get "log" m "format" <> Json.String "taut-exact/1" then Json.error "format" "expected \"taut-exact/1\"";
  { proved_until = number "until" (Json.get "log" m "until");
    pairs = map (fun v ->
      let m = Json.members "pairs" [ "pair"; "windows" ] v in
      let a, b = Json.pair "pair" (Json.get "pairs" m "pair") in
      ((index a, index b), map window (Json.list "windows" (Json.get "pairs" m "windows"))))
      (Json.list "pairs" (Json.get "log" m "pairs")) }
