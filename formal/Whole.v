(** Placements in whole numbers: polynomials in u = h / r with integer coefficients, which a processor can multiply. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
From Taut Require Import Definitions Numbers Models Placement Outlines.
Import ListNotations.
Open Scope R_scope.

(** * Polynomials on [-1, 1], of several functions at once *)

Fixpoint count {A} (l : list A) : Z := match l with [] => 0 | _ :: l => 1 + count l end.
Fixpoint scaled (g : Z) (w r : number) (p : poly) : list Z :=
  match p with [] => [] | a :: p => whole g (mul w a) :: scaled g (mul w r) r p end.
(** Without small terms at the end, and how much they are at most. *)
Fixpoint trimmed (small : Z) (l : list Z) : list Z * Z :=
  match l with
  | [] => ([], 0%Z)
  | a :: l => match trimmed small l with
              | ([], e) => if Z.leb (Z.abs a) small then ([], (e + Z.abs a)%Z) else ([a], e)
              | (l, e) => (a :: l, e)
              end
  end.
(** A model in multiples of 2^g, and by how many the function is off it at most. *)
Definition whole_model (g small : Z) (r : number) (M : model) : list Z * Z :=
  let l := scaled g one r (poly_of M) in
  let (t, e) := trimmed small l in (t, (e + count l + whole g (slack M) + 1)%Z).

Fixpoint zipped {A B} (a0 : A) (b0 : B) (p : list A) (q : list B) : list (A * B) :=
  match p, q with
  | [], _ => map (fun b => (a0, b)) q
  | a :: p, [] => (a, b0) :: zipped a0 b0 p []
  | a :: p, b :: q => (a, b) :: zipped a0 b0 p q
  end.

(** Of the place in multiples of 2^(g - 20), of cosine and sine in multiples of 2^-28, where g is the grid of vertices. *)
Record whole_placement := WholePlacement { coefficients : list ((Z * Z) * (Z * Z)); off_place : Z; off_turn : Z }.
Definition place_bits := 20%Z.
Definition turn_bits := 28%Z.
Definition small_place := 65536%Z.
Definition small_turn := 16%Z.
Definition whole_of (g : Z) (r : number) (P : placement) : whole_placement :=
  let (x, ex) := whole_model (g - place_bits) small_place r (ox P) in
  let (y, ey) := whole_model (g - place_bits) small_place r (oy P) in
  let (c, ec) := whole_model (- turn_bits) small_turn r (co P) in
  let (s, es) := whole_model (- turn_bits) small_turn r (si P) in
  WholePlacement (zipped (0, 0)%Z (0, 0)%Z (zipped 0%Z 0%Z x y) (zipped 0%Z 0%Z c s)) (Z.max ex ey) (Z.max ec es).

(** * Correctness *)

Fixpoint series {A} (f : A -> Z) (l : list A) (u : R) : R := match l with [] => 0 | a :: l => IZR (f a) + u * series f l u end.
Definition self (a : Z) : Z := a.

Lemma count_nonneg {A} (l : list A) : (0 <= count l)%Z.
Proof. induction l; cbn [count]; lia. Qed.

Lemma Rabs_within x e : Rabs x <= e -> - e <= x <= e.
Proof. unfold Rabs. destruct (Rcase_abs x); lra. Qed.

(** One term more or less in a sum in powers of u. *)
Lemma horner_step u a b x y e d : Rabs u <= 1 -> Rabs (a - b) <= e -> Rabs (x - y) <= d -> Rabs (a + u * x - (b + u * y)) <= e + d.
Proof.
  intros U A X. replace (a + u * x - (b + u * y)) with (a - b + u * (x - y)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  assert (Rabs u * Rabs (x - y) <= 1 * Rabs (x - y)) by (apply Rmult_le_compat_r; auto using Rabs_pos). lra.
Qed.

Lemma scaled_correct g r p u : Rabs u <= 1 -> forall w,
  Rabs (value w * eval p (value r * u) - series self (scaled g w r p) u * powerRZ 2 g) <= IZR (count (scaled g w r p)) * powerRZ 2 g.
Proof.
  intros U. induction p as [|a p IH]; intros w; cbn [scaled series count eval].
  - rewrite Rmult_0_r, !Rmult_0_l, Rminus_0_r, Rabs_R0. lra.
  - specialize (IH (mul w r)). rewrite value_mul in IH. rewrite plus_IZR. set (s := powerRZ 2 g) in *.
    pose proof (whole_correct g (mul w a)) as W. rewrite value_mul in W. fold s in W. unfold self at 1.
    rewrite (Rmult_plus_distr_r 1), Rmult_1_l.
    replace (_ - _) with (value w * value a + u * (value w * value r * eval p (value r * u)) -
      (IZR (whole g (mul w a)) * s + u * (series self (scaled g (mul w r) r p) u * s))) by ring.
    apply horner_step; auto.
Qed.

Lemma trimmed_correct small l u : Rabs u <= 1 ->
  Rabs (series self l u - series self (fst (trimmed small l)) u) <= IZR (snd (trimmed small l)).
Proof.
  intros U. induction l as [|a l IH]; cbn [trimmed].
  - simpl. rewrite Rminus_0_r, Rabs_R0. lra.
  - assert (S : forall t e, trimmed small l = (t, e) -> Rabs (series self (a :: l) u - series self (a :: t) u) <= IZR e).
    { intros t e E. rewrite E in IH. cbn [fst snd] in IH. cbn [series]. replace (IZR e) with (0 + IZR e) by ring.
      apply horner_step; auto. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra. }
    destruct (trimmed small l) as [[|b t] e] eqn:E; [|apply (S (b :: t) e); auto].
    destruct (Z.leb (Z.abs a) small); [|apply (S [] e); auto]. cbn [fst snd series] in *.
    rewrite plus_IZR, abs_IZR. replace (IZR e + Rabs (IZR a)) with (Rabs (IZR a) + IZR e) by ring.
    replace 0 with (0 + u * 0) at 1 by ring. apply horner_step; auto. rewrite Rminus_0_r. unfold self. lra.
Qed.

(** h = r u, for the radius that is not less than the window's. *)
Definition same_instant (r h u : R) : Prop := Rabs u <= 1 /\ h = r * u.

Lemma whole_model_correct g small r s f M : near r f M ->
  forall h u, Rabs h <= value r -> same_instant (value s) h u ->
  Rabs (f h - series self (fst (whole_model g small s M)) u * powerRZ 2 g) <= IZR (snd (whole_model g small s M)) * powerRZ 2 g.
Proof.
  intros N h u H [U E]. specialize (N h H). unfold whole_model.
  pose proof (scaled_correct g s (poly_of M) u U one) as S. rewrite value_one, Rmult_1_l, <- E in S.
  set (l := scaled g one s (poly_of M)) in *. pose proof (trimmed_correct small l u U) as T.
  destruct (trimmed small l) as [t e]. cbn [fst snd] in *. rewrite !plus_IZR.
  pose proof (whole_correct g (slack M)) as W. pose proof (two_pos g) as P. set (c := powerRZ 2 g) in *.
  assert (SL : value (slack M) <= IZR (whole g (slack M)) * c + c) by (apply Rabs_within in W; lra).
  assert (TC : Rabs (series self l u * c - series self t u * c) <= IZR e * c).
  { replace (_ - _) with ((series self l u - series self t u) * c) by ring. rewrite Rabs_mult, (Rabs_right c) by lra.
    apply Rmult_le_compat_r; lra. }
  apply Rabs_le. apply Rabs_within in N, S, TC. lra.
Qed.

Lemma series_const {A B} (f : B -> Z) (m : A -> B) (l : list A) u : (forall a, f (m a) = 0%Z) -> series f (map m l) u = 0.
Proof. intros H. induction l; simpl; auto. rewrite H, IHl. ring. Qed.
Lemma series_map {A B} (f : B -> Z) (m : A -> B) (l : list A) u : series f (map m l) u = series (fun a => f (m a)) l u.
Proof. induction l; simpl; auto. rewrite IHl. ring. Qed.
Lemma zipped_first {A B} (f : A -> Z) a0 (b0 : B) p q u : f a0 = 0%Z -> series (fun c => f (fst c)) (zipped a0 b0 p q) u = series f p u.
Proof.
  intros F. revert q; induction p as [|a p IH]; intros q.
  - simpl. apply (series_const (fun c => f (fst c))). auto.
  - destruct q; cbn [zipped series fst]; rewrite IH; auto.
Qed.
Lemma zipped_second {A B} (f : B -> Z) (a0 : A) b0 p q u : f b0 = 0%Z -> series (fun c => f (snd c)) (zipped a0 b0 p q) u = series f q u.
Proof.
  intros F. revert q; induction p as [|a p IH]; intros q.
  - simpl. apply (series_map (fun c => f (snd c))).
  - destruct q; cbn [zipped series snd]; rewrite IH, ?F; cbn [series]; ring.
Qed.
