(** Edges of a body as a tree of halves, each with a box around it, in whole multiples of 2^g. *)

From Coq Require Import Reals ZArith List Bool PeanoNat Lra Lia Psatz.
From Taut Require Import Definitions Numbers.
Import ListNotations.
Open Scope R_scope.

Definition vertex := (number * number)%type.
Definition edge := (vertex * vertex)%type.

(** A number in whole multiples of 2^g, rounded down. *)
Definition whole (g : Z) (a : number) : Z := Z.shiftl (mantissa a) (exponent a - g).
Definition cell := (Z * Z)%type.
Definition cell_of (g : Z) (v : vertex) : cell := (whole g (fst v), whole g (snd v)).

(** An interval, as its middle and how far it reaches from there; a box is two of them. *)
Definition span := (Z * Z)%type.
Definition box := (span * span)%type.
Definition joined (a b : span) : span :=
  let high := Z.max (fst a + snd a) (fst b + snd b) in
  let low := (- Z.max (snd a - fst a) (snd b - fst b))%Z in
  let middle := Z.shiftr (low + high) 1 in (middle, Z.max (high - middle) (middle - low)).
Definition joined_boxes (a b : box) : box := (joined (fst a) (fst b), joined (snd a) (snd b)).
Definition cell_box (c : cell) : box := ((fst c, 0%Z), (snd c, 0%Z)).

Inductive tree :=
| Empty
| Leaf (e : edge) (around : box) (first second : cell)
| Node (around : box) (t1 t2 : tree).

Definition leaf (g : Z) (e : edge) : tree :=
  let c := cell_of g (fst e) in let d := cell_of g (snd e) in Leaf e (joined_boxes (cell_box c) (cell_box d)) c d.
Definition box_of (t : tree) : box :=
  match t with Empty => ((0, 0), (0, 0))%Z | Leaf _ b _ _ => b | Node b _ _ => b end.
Definition node (t1 t2 : tree) : tree := Node (joined_boxes (box_of t1) (box_of t2)) t1 t2.

(** Halves of halves; a depth of the list's length is more than it takes. *)
Fixpoint tree_of (depth : nat) (g : Z) (l : list edge) : tree :=
  match l with
  | [] => Empty
  | [e] => leaf g e
  | _ => match depth with
         | O => fold_right (fun e t => node (leaf g e) t) Empty l
         | S depth => let n := Nat.div2 (length l) in node (tree_of depth g (firstn n l)) (tree_of depth g (skipn n l))
         end
  end.
Definition halves (t : tree) : tree * tree := match t with Node _ t1 t2 => (t1, t2) | _ => (Empty, t) end.

(** * Correctness *)

Lemma shiftr_close m k : Rabs (IZR m - IZR (Z.shiftr m k) * powerRZ 2 k) <= powerRZ 2 k.
Proof.
  pose proof (two_pos k) as P. destruct (Z.leb_spec 0 k) as [H|H].
  - destruct (shiftr_bounds m k H) as [L U]. apply Rabs_le. lra.
  - replace k with (- (- k))%Z by lia. rewrite Z.shiftr_opp_r, shiftl_value by lia. rewrite Rmult_assoc, <- two_add.
    replace (- k + - - k)%Z with 0%Z by lia. simpl powerRZ at 1. rewrite Rmult_1_r, Rminus_diag_eq, Rabs_R0 by reflexivity.
    left. apply two_pos.
Qed.

Transparent value.
Lemma whole_correct g a : Rabs (value a - IZR (whole g a) * powerRZ 2 g) <= powerRZ 2 g.
Proof.
  unfold whole, value. replace (exponent a - g)%Z with (- (g - exponent a))%Z by lia. rewrite Z.shiftl_opp_r.
  set (k := (g - exponent a)%Z). pose proof (shiftr_close (mantissa a) k) as H. pose proof (two_pos (exponent a)) as P.
  replace g with (k + exponent a)%Z by (unfold k; lia). rewrite two_add. set (e := powerRZ 2 (exponent a)) in *.
  replace (_ - _) with ((IZR (mantissa a) - IZR (Z.shiftr (mantissa a) k) * powerRZ 2 k) * e) by ring.
  rewrite Rabs_mult, (Rabs_right e) by lra. apply Rmult_le_compat_r; lra.
Qed.
Global Opaque value.

Definition close (g : Z) (v : vertex) (c : cell) : Prop :=
  Rabs (value (fst v) - IZR (fst c) * powerRZ 2 g) <= powerRZ 2 g /\ Rabs (value (snd v) - IZR (snd c) * powerRZ 2 g) <= powerRZ 2 g.
Lemma cell_of_close g v : close g v (cell_of g v).
Proof. split; apply whole_correct. Qed.

Definition in_span (x : Z) (s : span) : Prop := (Z.abs (x - fst s) <= snd s)%Z.
Definition in_box (c : cell) (b : box) : Prop := in_span (fst c) (fst b) /\ in_span (snd c) (snd b).

Lemma joined_correct a b x : in_span x a \/ in_span x b -> in_span x (joined a b).
Proof.
  unfold in_span, joined. cbn [fst snd]. set (m := Z.shiftr _ 1). clearbody m. intros [H|H]; lia.
Qed.
Lemma joined_boxes_correct a b c : in_box c a \/ in_box c b -> in_box c (joined_boxes a b).
Proof. unfold in_box, joined_boxes. cbn [fst snd]. intros [[]|[]]; split; apply joined_correct; auto. Qed.
Lemma in_cell_box c : in_box c (cell_box c).
Proof. split; unfold in_span; simpl; lia. Qed.

Fixpoint in_tree (e : edge) (t : tree) : Prop :=
  match t with Empty => False | Leaf e' _ _ _ => e = e' | Node _ t1 t2 => in_tree e t1 \/ in_tree e t2 end.
Definition ends_in (g : Z) (e : edge) (b : box) : Prop := in_box (cell_of g (fst e)) b /\ in_box (cell_of g (snd e)) b.
(** Cells are those of the ends, and boxes hold them. *)
Fixpoint right_tree (g : Z) (t : tree) : Prop :=
  (forall e, in_tree e t -> ends_in g e (box_of t)) /\
  match t with
  | Empty => True
  | Leaf e _ c d => c = cell_of g (fst e) /\ d = cell_of g (snd e)
  | Node _ t1 t2 => right_tree g t1 /\ right_tree g t2
  end.
Lemma right_ends g t e : right_tree g t -> in_tree e t -> ends_in g e (box_of t).
Proof. destruct t; intros []; auto. Qed.

Lemma right_leaf g e : right_tree g (leaf g e).
Proof.
  split; [|split; reflexivity]. intros e' ->. split; apply joined_boxes_correct; [left|right]; apply in_cell_box.
Qed.
Lemma right_node g t1 t2 : right_tree g t1 -> right_tree g t2 -> right_tree g (node t1 t2).
Proof.
  intros H1 H2. split; [|split; auto].
  intros e [I|I]; [destruct (right_ends g t1 e H1 I)|destruct (right_ends g t2 e H2 I)]; split; apply joined_boxes_correct; auto.
Qed.
Lemma right_empty g : right_tree g Empty.
Proof. split; auto. intros e []. Qed.

Lemma tree_of_correct depth g l : right_tree g (tree_of depth g l) /\ forall e, In e l -> in_tree e (tree_of depth g l).
Proof.
  revert l. assert (O : forall l, right_tree g (fold_right (fun e t => node (leaf g e) t) Empty l) /\
                                 forall e, In e l -> in_tree e (fold_right (fun e t => node (leaf g e) t) Empty l)).
  { induction l as [|e l [IH1 IH2]]; cbn [fold_right]; [split; [apply right_empty|intros e []]|]. split.
    - apply right_node; auto using right_leaf.
    - intros e' [->|I]; simpl; auto. }
  assert (S : forall l, match l with [e] => right_tree g (leaf g e) /\ forall e', In e' [e] -> in_tree e' (leaf g e) | _ => True end).
  { intros [|e [|]]; auto. split; [apply right_leaf|]. intros e' [->|[]]. reflexivity. }
  assert (N : right_tree g Empty /\ forall e, In e [] -> in_tree e Empty) by (split; [apply right_empty|auto]).
  induction depth as [|depth IH]; intros l; specialize (S l); destruct l as [|e [|e' l]]; auto; [apply (O (e :: e' :: l))|].
  set (whole_list := e :: e' :: l). set (n := Nat.div2 (length whole_list)).
  change (tree_of (Datatypes.S depth) g whole_list)
    with (node (tree_of depth g (firstn n whole_list)) (tree_of depth g (skipn n whole_list))).
  destruct (IH (firstn n whole_list)) as [A1 A2]. destruct (IH (skipn n whole_list)) as [B1 B2].
  split; [apply right_node; auto|]. intros x I. rewrite <- (firstn_skipn n whole_list) in I.
  apply in_app_or in I. destruct I; [left; auto|right; auto].
Qed.

Lemma halves_correct g t : right_tree g t -> right_tree g (fst (halves t)) /\ right_tree g (snd (halves t)) /\
  forall e, in_tree e t -> in_tree e (fst (halves t)) \/ in_tree e (snd (halves t)).
Proof.
  destruct t as [|e b c d|b t1 t2]; simpl; auto using right_empty.
  - intros H. split; [apply right_empty|]. auto.
  - intros (_ & H1 & H2). auto.
Qed.
