(** What the theorem speaks of, on one page. Everything that has to be believed about scenes is here and in the statement of
    [accepted_is_free] (Soundness.v); the other files are proofs, and Coq has checked them. *)

From Coq Require Import Reals ZArith List Bool.
Import ListNotations.
Open Scope R_scope.

(** * Numbers: m * 2^e, which all doubles are *)

Record number := Number { mantissa : Z; exponent : Z }.
Definition value (a : number) : R := IZR (mantissa a) * powerRZ 2 (exponent a).

(** * Polygons *)

Definition point := (R * R)%type.
Definition ring := list point.
(** An outline and its holes, in any order and orientation. *)
Definition part := list ring.

Fixpoint steps {A} (first : A) (r : list A) : list (A * A) :=
  match r with
  | [] => []
  | u :: rest => (u, match rest with v :: _ => v | [] => first end) :: steps first rest
  end.
(** From each vertex to the next one, and from the last one to the first. *)
Definition edges {A} (r : list A) : list (A * A) := match r with [] => [] | first :: _ => steps first r end.

Definition less (a b : R) : bool := if Rlt_dec a b then true else false.

(** The ray from z to the right crosses the edge from u to v: one end is above the ray's line and the other is not, and the
    edge passes that line to the right of z. *)
Definition crosses (z u v : point) : bool :=
  xorb (less (snd z) (snd u)) (less (snd z) (snd v)) &&
  less (fst z) (fst u + (snd z - snd u) * ((fst v - fst u) / (snd v - snd u))).

(** Whether the number of crossings is odd. *)
Definition odd_ring (z : point) (r : ring) : bool :=
  fold_right (fun e odd => xorb (crosses z (fst e) (snd e)) odd) false (edges r).
Definition odd (z : point) (p : part) : bool := fold_right (fun r odd => xorb (odd_ring z r) odd) false p.

Definition on_edge (z u v : point) : Prop :=
  exists k, 0 <= k <= 1 /\ z = (fst u + k * (fst v - fst u), snd u + k * (snd v - snd u)).
Definition on_boundary (z : point) (p : part) : Prop :=
  exists r e, In r p /\ In e (edges r) /\ on_edge z (fst e) (snd e).

(** A part is closed: its boundary belongs to it. *)
Definition in_part (z : point) (p : part) : Prop := on_boundary z p \/ odd z p = true.

(** * Motions *)

(** Coefficients in ascending powers. *)
Fixpoint eval (p : list number) (x : R) : R := match p with [] => 0 | a :: q => value a + x * eval q x end.

Inductive rotation :=
| Fixed                                    (* no rotation *)
| Angle (a : list number)                  (* by a(x), in radians *)
| HalfAngleTangent (s : list number)       (* by 2 arctan s(x) *)
| Direction (a b : list number)            (* (1, 0) turns into the direction of (a(x), b(x)) *)
| Cosine (a : list number).                (* by an angle from 0 to pi, whose cosine is a(x), or 1 or -1 beyond these *)

Definition cos_sin (r : rotation) (x : R) : R * R :=
  match r with
  | Fixed => (1, 0)
  | Angle a => (cos (eval a x), sin (eval a x))
  | HalfAngleTangent p => let s := eval p x in ((1 - s * s) / (1 + s * s), 2 * s / (1 + s * s))
  | Direction a b => let n := sqrt (eval a x * eval a x + eval b x * eval b x) in (eval a x / n, eval b x / n)
  | Cosine a => let c := Rmax (-1) (Rmin 1 (eval a x)) in (c, sqrt (1 - c * c))
  end.

(** A piece of a motion, up to the time [until]; its polynomials are in x = t - [origin]. *)
Record piece := Piece {
  until : number;
  origin : number;
  shift : list number * list number;
  turn : rotation;
  pivot : number * number;
  orbit : option ((number * number) * list number)     (* a centre, and an angle in radians *)
}.

Definition turned (cs : R * R) (p : point) : point :=
  (fst cs * fst p - snd cs * snd p, snd cs * fst p + fst cs * snd p).
Definition plus (p q : point) : point := (fst p + fst q, snd p + snd q).
Definition minus (p q : point) : point := (fst p - fst q, snd p - snd q).
Definition values (p : number * number) : point := (value (fst p), value (snd p)).

(** The pivot is moved by [shift], then around the orbit's centre; the body turns about it. *)
Definition pose (m : piece) (t : R) (p : point) : point :=
  let x := t - value (origin m) in
  let moved := plus (values (pivot m)) (eval (fst (shift m)) x, eval (snd (shift m)) x) in
  let place :=
    match orbit m with
    | None => moved
    | Some (centre, a) => plus (values centre) (turned (cos (eval a x), sin (eval a x)) (minus moved (values centre)))
    end in
  plus place (turned (cos_sin (turn m) x) (minus p (values (pivot m)))).

(** At a joint, both the piece that ends and the piece that begins count: [after] says which one is meant. The last piece
    has no end. *)
Definition motion := list piece.
Fixpoint piece_at (after : bool) (m : motion) (t : R) : option piece :=
  match m with
  | [] => None
  | [last] => Some last
  | p :: rest => if (if after then less t (value (until p)) else negb (less (value (until p)) t))
                 then Some p else piece_at after rest t
  end.

Definition follow (after : bool) (m : motion) (t : R) (p : point) : point :=
  match piece_at after m t with None => p | Some piece => pose piece t p end.

(** * Scenes *)

(** A body's own motion is the last one of its chain; those before are its parents', the outermost first. *)
Record body := Body { chain : list motion; shape : list (list (list (number * number))) }.

Record scene := Scene {
  start : number;
  stop : number;                      (* the end of the scene's time; a log says itself up to when it proves something *)
  bodies : list body;
  ignored : list (nat * nat);
  at_rest : bool                      (* whether pairs with one and the same chain are tested *)
}.

Definition placed (after : bool) (c : list motion) (t : R) (p : point) : point :=
  fold_right (fun m q => follow after m t q) p c.

(** The points that a body covers: the union of its parts, in the place where its chain puts it. *)
Definition covers (b : body) (after : bool) (t : R) (z : point) : Prop :=
  exists p q, In p (shape b) /\ in_part q (map (map values) p) /\ z = placed after (chain b) t q.

(** Bodies are named by their index; the first of a pair is the one with the smaller index. *)
Definition tested (s : scene) (i j : nat) (a b : body) : Prop :=
  (i < j)%nat /\ nth_error (bodies s) i = Some a /\ nth_error (bodies s) j = Some b /\
  ~ In (i, j) (ignored s) /\ ~ In (j, i) (ignored s) /\ (at_rest s = true \/ chain a <> chain b).

(** No two tested bodies have a point in common, at any instant from the scene's start to a time. Before the start there is
    nothing, so at the start only the pieces count that begin there or go on. *)
Definition free_until (s : scene) (time : R) : Prop :=
  forall t after, value (start s) <= t <= time -> (after = false -> value (start s) < t) ->
  forall i j a b, tested s i j a b -> forall z, ~ (covers a after t z /\ covers b after t z).
