(** Models of sine, cosine, reciprocals and reciprocal square roots. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
From Taut Require Import Definitions Numbers Models.
Import ListNotations.
Open Scope R_scope.

Definition widen (e : number) (M : model) : model := Model (poly_of M) (round_up (add (slack M) e)).
(** 1 / n *)
Definition inverse (n : Z) : model := Model [Number (Z.div (Z.shiftl 1 120) n) (-120)] (Number 1 (-120)).
Definition square (a : number) : number := mul a a.

(** Sine and cosine where |x| <= 2. *)
Definition largest_angle := Number 1 1.
Definition sin_small (r : number) (X : model) : model :=
  let b := round_up (bound r X) in
  let y := mmul r X X in
  let one_less k M := msub (constant one) (mmul r (mmul r y (inverse k)) M) in
  let b2 := square b in
  widen (mul (Number 1 (-12)) (mul b (mul b2 (square b2)))) (mmul r X (one_less 6%Z (one_less 20%Z (constant one)))).
Definition cos_small (r : number) (X : model) : model :=
  let b := round_up (bound r X) in
  let y := mmul r X X in
  let one_less k M := msub (constant one) (mmul r (mmul r y (inverse k)) M) in
  widen (mul (Number 1 (-15)) (square (square (square b)))) (one_less 2%Z (one_less 12%Z (one_less 30%Z (constant one)))).

(** (cos 2x, sin 2x) *)
Definition double_angle (r : number) (cs : model * model) : model * model :=
  let (c, s) := cs in
  let two := Number 1 1 in
  (msub (constant one) (mscale two (mmul r s s)), mscale two (mmul r s c)).
Fixpoint iterate {A} (n : nat) (f : A -> A) (x : A) : A := match n with O => x | S n => iterate n f (f x) end.
(** Of a number, halved until it is at most 2^-14. *)
Definition halvings (a : number) : nat :=
  if Z.eqb (mantissa a) 0 then O else Z.to_nat (Z.log2 (Z.abs (mantissa a)) + exponent a + 15).
Definition cos_sin_number (r a : number) : option (model * model) :=
  let n := halvings a in
  let X := constant (iterate n half a) in
  if at_most (round_up (bound r X)) largest_angle then Some (iterate n (double_angle r) (cos_small r X, sin_small r X)) else None.

(** Of a function, by its value at h = 0 and what is added to it. *)
Definition cos_sin_model (r : number) (X : model) : option (model * model) :=
  let a := match poly_of X with [] => zero | a :: _ => a end in
  let D := msub X (constant a) in
  if at_most (round_up (bound r D)) largest_angle && Nat.leb (halvings a) 200 then
    match cos_sin_number r a with
    | None => None
    | Some (c0, s0) =>
        let c := cos_small r D in let s := sin_small r D in
        Some (msub (mmul r c0 c) (mmul r s0 s), madd (mmul r s0 c) (mmul r c0 s))
    end
  else None.

(** 1 / f where f >= 1: the result is right whatever its origin, Newton's iteration; the residue tells by how much. *)
Definition guess_reciprocal (r : number) (X : model) : poly :=
  let a := match poly_of X with [] => one | a :: _ => a end in
  let k := (Z.log2 (Z.abs (mantissa a)) + 64)%Z in
  let g := [Number (Z.div (Z.shiftl 1 k) (Z.max 1 (mantissa a))) (- k - exponent a)] in
  iterate 4 (fun g => poly_of (tidy r (Model (pmul g (padd [Number 2 0] (pneg (poly_of (mmul r X (Model g zero)))))) zero))) g.
Definition reciprocal (r : number) (X : model) : model :=
  let g := guess_reciprocal r X in
  let residue := msub (constant one) (mmul r X (Model g zero)) in
  Model g (round_up (bound r residue)).

(** 1 / sqrt f where f >= 0; None if it is too near to 0. *)
Definition guess_root (r : number) (X : model) : poly :=
  let a := match poly_of X with [] => one | a :: _ => a end in
  (* a = m 2^e: with e made even and 128 bits, 2^k / sqrt m *)
  let e := exponent a in
  let odd_e := Z.odd e in
  let m := if odd_e then (2 * mantissa a)%Z else mantissa a in
  let e := if odd_e then (e - 1)%Z else e in
  let root := Z.max 1 (Z.sqrt (Z.shiftl (Z.max 0 m) 128)) in
  (* sqrt a = root 2^(e/2 - 64) *)
  let k := (Z.log2 root + 64)%Z in
  let g := [Number (Z.div (Z.shiftl 1 k) root) (- k + 64 - Z.div e 2)] in
  iterate 4 (fun g =>
    let G := Model g zero in
    let y := mmul r X (mmul r G G) in
    poly_of (mscale (Number 1 (-1)) (mmul r G (msub (constant (Number 3 0)) y)))) g.
Definition certified_root (r : number) (X : model) (g : poly) : option model :=
  let G := Model g zero in
  let residue := round_up (bound r (msub (constant one) (mmul r X (mmul r G G)))) in
  if at_most residue (Number 1 (-1)) && below zero (lower r g)
  then Some (Model g (round_up (mul (Number 1 1) (mul residue (norm r g)))))
  else None.
Definition reciprocal_root (r : number) (X : model) : option model := certified_root r X (guess_root r X).

(** Cut off at 1 and -1. *)
Definition clamp (x : R) : R := Rmax (-1) (Rmin 1 x).
Definition clamp_model (r : number) (X : model) : model :=
  let d := msub (constant one) (mmul r X X) in
  if below (slack d) (lower r (poly_of d)) then X
  else let e := sub (bound r X) one in if below zero e then widen e X else X.

(** Not less than the root of a number. *)
Definition root_above (a : number) : number :=
  let e := Z.div (exponent a) 2 in
  Number (Z.sqrt (Z.shiftl (Z.max 0 (mantissa a)) (exponent a - 2 * e + 64)) + 1) (e - 32).
(** sqrt f where f >= 0: smooth where f is clear of 0, else between 0 and the root of a bound. *)
Definition root_model (r : number) (X : model) : option model :=
  match reciprocal_root r X with
  | Some i => Some (mmul r X i)
  | None =>
      let b := round_up (bound r X) in
      let s := root_above b in
      if at_most zero s && at_most b (mul s s) then Some (Model [half s] (half s)) else None
  end.

(** * Correctness *)

Lemma near_widen r f g M e : near r f M -> (forall h, Rabs h <= value r -> Rabs (g h - f h) <= value e) -> near r g (widen e M).
Proof.
  intros F G h Hh. simpl. eapply Rle_trans; [|apply round_up_correct]. rewrite value_add. specialize (F h Hh). specialize (G h Hh).
  replace (_ - _) with (g h - f h + (f h - eval (poly_of M) h)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

Transparent value.
Lemma near_inverse r n : (0 < n)%Z -> near r (fun _ => / IZR n) (inverse n).
Proof.
  intros P h _. unfold inverse. cbn [poly_of slack eval]. rewrite Rmult_0_r, Rplus_0_r. unfold value. cbn [mantissa exponent].
  set (q := (Z.shiftl 1 120 / n)%Z). rewrite Rmult_1_l. pose proof (two_pos (-120)) as T.
  assert (E : IZR (2 ^ 120) * powerRZ 2 (-120) = 1).
  { rewrite <- two_nat by lia. rewrite <- two_add. reflexivity. }
  pose proof (Z.div_mod (Z.shiftl 1 120) n ltac:(lia)) as D. pose proof (Z.mod_pos_bound (Z.shiftl 1 120) n P) as M. fold q in D.
  change (Z.shiftl 1 120) with (2 ^ 120)%Z in *.
  assert (L : IZR n * IZR q <= IZR (2 ^ 120)) by (rewrite <- mult_IZR; apply IZR_le; lia).
  assert (U : IZR (2 ^ 120) <= IZR n * IZR q + IZR n) by (rewrite <- mult_IZR, <- plus_IZR; apply IZR_le; lia).
  assert (N : 0 < IZR n) by (apply (IZR_lt 0); auto). assert (I : 0 < / IZR n) by (apply Rinv_0_lt_compat; auto).
  assert (F : / IZR n * IZR n = 1) by (apply Rinv_l; lra).
  set (x := powerRZ 2 (-120)) in *. set (i := / IZR n) in *. set (m := IZR n) in *. set (z := IZR q) in *.
  set (b := IZR (2 ^ 120)) in *. clearbody x i m z b.
  assert (i = i * (b * x)) by (rewrite E; ring).
  assert (0 <= i * x) by nra.
  assert (i * x * (m * z) <= i * x * b) by (apply Rmult_le_compat_l; auto).
  assert (i * x * b <= i * x * (m * z + m)) by (apply Rmult_le_compat_l; auto).
  replace (i * x * (m * z)) with (i * m * (x * z)) in * by ring.
  replace (i * x * (m * z + m)) with (i * m * (x * z + x)) in * by ring. rewrite F in *.
  apply Rabs_le. split; lra.
Qed.

Lemma value_power k : (0 <= k)%Z -> value (Number 1 (- k)) = / IZR (2 ^ k).
Proof.
  intros H. unfold value; cbn [mantissa exponent]. rewrite Rmult_1_l, <- two_nat by auto. pose proof (two_pos k).
  apply (Rmult_eq_reg_r (powerRZ 2 k)); [|lra]. rewrite <- two_add, Z.add_opp_diag_l, Rinv_l by lra. reflexivity.
Qed.
Lemma value_Z n : value (Number n 0) = IZR n.
Proof. unfold value; simpl. ring. Qed.
Lemma value_two : value (Number 1 1) = 2.
Proof. unfold value; simpl. ring. Qed.
Opaque value.

Lemma factorial n z : Z.of_nat (fact n) = z -> INR (fact n) = IZR z.
Proof. intros <-. apply INR_IZR_INZ. Qed.

Lemma sin_series x : 0 <= x <= 2 -> Rabs (sin x - x * (1 - x * x * / 6 * (1 - x * x * / 20))) <= / 4096 * (x * (x * x * (x * x * (x * x)))).
Proof.
  intros H. destruct (pre_sin_bound x 1) as [L _]; [lra|lra|]. destruct (pre_sin_bound x 0) as [_ U]; [lra|lra|].
  unfold sin_approx, sin_term in L, U. cbn [sum_f_R0 Nat.mul Nat.add] in L, U.
  rewrite (factorial 1 1), (factorial 3 6), (factorial 5 120) in L, U by reflexivity. rewrite (factorial 7 5040) in L by reflexivity.
  simpl pow in L, U.
  assert (P : 0 <= x * (x * x * (x * x * (x * x)))) by (repeat apply Rmult_le_pos; lra).
  apply Rabs_le. split; [|].
  - eapply Rle_trans; [|apply Rplus_le_compat_r, L]. field_simplify. field_simplify in P. lra.
  - eapply Rle_trans; [apply Rplus_le_compat_r, U|]. field_simplify. field_simplify in P. lra.
Qed.

Lemma cos_series x : -2 <= x <= 2 ->
  Rabs (cos x - (1 - x * x * / 2 * (1 - x * x * / 12 * (1 - x * x * / 30)))) <= / 32768 * (x * x * (x * x) * (x * x * (x * x))).
Proof.
  intros H. destruct (pre_cos_bound x 1) as [L U]; [lra|lra|].
  unfold cos_approx, cos_term in L, U. cbn [sum_f_R0 Nat.mul Nat.add] in L, U.
  rewrite (factorial 0 1), (factorial 2 2), (factorial 4 24), (factorial 6 720) in L, U by reflexivity.
  rewrite (factorial 8 40320) in U by reflexivity. simpl pow in L, U.
  assert (P : 0 <= x * x * (x * x) * (x * x * (x * x))) by (pose proof (Rle_0_sqr (x * x * (x * x))); unfold Rsqr in *; lra).
  apply Rabs_le. split.
  - eapply Rle_trans; [|apply Rplus_le_compat_r, L]. field_simplify. field_simplify in P. lra.
  - eapply Rle_trans; [apply Rplus_le_compat_r, U|]. field_simplify. field_simplify in P. lra.
Qed.

Section Correctness.
  Variable r : number.
  Hypothesis R : 0 <= value r.

  Lemma near_one_less y Y k f M : near r y Y -> (0 < k)%Z -> near r f M ->
    near r (fun h => 1 - y h * / IZR k * f h) (msub (constant one) (mmul r (mmul r Y (inverse k)) M)).
  Proof.
    intros HY K F. apply (near_ext r (fun h => value one - y h * / IZR k * f h)); [intros; rewrite value_one; auto|].
    apply near_msub; [apply near_constant|]. apply (near_mmul r R (fun h => y h * / IZR k)); auto.
    apply near_mmul; auto. apply (near_ext r (fun _ => / IZR k)); auto. apply near_inverse; auto.
  Qed.

  Lemma in_bound f X h : near r f X -> Rabs h <= value r -> Rabs (f h) <= value (round_up (bound r X)).
  Proof. intros F H. eapply Rle_trans; [apply (bound_correct r f X h F H)|apply round_up_correct]. Qed.

  Lemma one_near : near r (fun _ => 1) (constant one).
  Proof. apply (near_ext r (fun _ => value one)); [intros; apply value_one|apply near_constant]. Qed.

  Lemma near_sin_small f X : near r f X -> at_most (round_up (bound r X)) largest_angle = true ->
    near r (fun h => sin (f h)) (sin_small r X).
  Proof.
    intros F B. apply at_most_correct in B. unfold largest_angle in B. rewrite value_two in B. unfold sin_small.
    apply (near_widen r (fun h => f h * (1 - f h * f h * / IZR 6 * (1 - f h * f h * / IZR 20 * 1)))).
    - apply near_mmul; auto. apply (near_one_less (fun h => f h * f h)); [apply near_mmul; auto|lia|].
      apply (near_one_less (fun h => f h * f h)); [apply near_mmul; auto|lia|apply one_near].
    - intros h H. unfold square. rewrite !value_mul. change (Number 1 (-12)) with (Number 1 (- (12))). rewrite value_power by lia.
      pose proof (in_bound f X h F H) as I. set (b := value (round_up (bound r X))) in *. set (x := f h) in *.
      assert (S : Rabs (sin x - x * (1 - x * x * / 6 * (1 - x * x * / 20))) <=
                  / 4096 * (Rabs x * (Rabs x * Rabs x * (Rabs x * Rabs x * (Rabs x * Rabs x))))).
      { destruct (Rle_dec 0 x).
        - rewrite (Rabs_right x) in * by lra. apply sin_series; lra.
        - rewrite (Rabs_left x) in * by lra. pose proof (sin_series (- x)) as S. rewrite sin_neg in S.
          rewrite <- Rabs_Ropp. replace (- (sin x - _)) with (- sin x - - x * (1 - - x * - x * / 6 * (1 - - x * - x * / 20))) by ring.
          apply S; lra. }
      rewrite !Rmult_1_r. eapply Rle_trans; [exact S|]. change (2 ^ 12)%Z with 4096%Z. apply Rmult_le_compat_l; [lra|].
      pose proof (Rabs_pos x). repeat (apply Rmult_le_compat; try (repeat apply Rmult_le_pos; auto; fail); auto).
  Qed.

  Lemma near_cos_small f X : near r f X -> at_most (round_up (bound r X)) largest_angle = true ->
    near r (fun h => cos (f h)) (cos_small r X).
  Proof.
    intros F B. apply at_most_correct in B. unfold largest_angle in B. rewrite value_two in B. unfold cos_small.
    apply (near_widen r (fun h => 1 - f h * f h * / IZR 2 * (1 - f h * f h * / IZR 12 * (1 - f h * f h * / IZR 30 * 1)))).
    - apply (near_one_less (fun h => f h * f h)); [apply near_mmul; auto|lia|].
      apply (near_one_less (fun h => f h * f h)); [apply near_mmul; auto|lia|].
      apply (near_one_less (fun h => f h * f h)); [apply near_mmul; auto|lia|apply one_near].
    - intros h H. unfold square. rewrite !value_mul. change (Number 1 (-15)) with (Number 1 (- (15))). rewrite value_power by lia.
      pose proof (in_bound f X h F H) as I. set (b := value (round_up (bound r X))) in *. set (x := f h) in *.
      rewrite !Rmult_1_r. eapply Rle_trans; [apply cos_series; split_Rabs; lra|]. change (2 ^ 15)%Z with 32768%Z.
      apply Rmult_le_compat_l; [lra|].
      replace (x * x * (x * x) * (x * x * (x * x))) with (Rabs x * Rabs x * (Rabs x * Rabs x) * (Rabs x * Rabs x * (Rabs x * Rabs x))).
      2: { assert (E : Rabs x * Rabs x = x * x) by (rewrite <- Rabs_mult; apply Rabs_right; nra). rewrite E. reflexivity. }
      pose proof (Rabs_pos x). repeat (apply Rmult_le_compat; try (repeat apply Rmult_le_pos; auto; fail); auto).
  Qed.

  Lemma iterate_half n a : value (iterate n half a) * 2 ^ n = value a.
  Proof. revert a; induction n; intros a; simpl; [ring|]. specialize (IHn (half a)). rewrite value_half in IHn. lra. Qed.

  Lemma near_double_angle x c s : near r (fun _ => cos x) c -> near r (fun _ => sin x) s ->
    near r (fun _ => cos (2 * x)) (fst (double_angle r (c, s))) /\ near r (fun _ => sin (2 * x)) (snd (double_angle r (c, s))).
  Proof.
    intros C S. simpl. split.
    - apply (near_ext r (fun _ => 1 - value (Number 1 1) * (sin x * sin x))).
      { intros _. rewrite value_two, cos_2a_sin. ring. }
      apply near_msub; [apply one_near|]. apply near_mscale. apply (near_mmul r R (fun _ => sin x) (fun _ => sin x)); auto.
    - apply (near_ext r (fun _ => value (Number 1 1) * (sin x * cos x))).
      { intros _. rewrite value_two, sin_2a. ring. }
      apply near_mscale. apply (near_mmul r R (fun _ => sin x) (fun _ => cos x)); auto.
  Qed.

  Lemma near_doubled n x cs : near r (fun _ => cos x) (fst cs) -> near r (fun _ => sin x) (snd cs) ->
    near r (fun _ => cos (x * 2 ^ n)) (fst (iterate n (double_angle r) cs)) /\
    near r (fun _ => sin (x * 2 ^ n)) (snd (iterate n (double_angle r) cs)).
  Proof.
    revert x cs; induction n as [|n IH]; intros x [c s] Hc Hs.
    - simpl. rewrite Rmult_1_r. auto.
    - cbn [iterate]. destruct (near_double_angle x c s Hc Hs) as [C' S'].
      replace (x * 2 ^ S n) with (2 * x * 2 ^ n) by (simpl; ring). apply IH; auto.
  Qed.

  Lemma near_cos_sin_number a c s : cos_sin_number r a = Some (c, s) ->
    near r (fun _ => cos (value a)) c /\ near r (fun _ => sin (value a)) s.
  Proof.
    unfold cos_sin_number. set (n := halvings a). set (X := constant (iterate n half a)).
    destruct (at_most (round_up (bound r X)) largest_angle) eqn:B; [|discriminate]. intros E.
    assert (N : near r (fun _ => value (iterate n half a)) X) by apply near_constant.
    pose proof (near_doubled n _ (cos_small r X, sin_small r X) (near_cos_small _ X N B) (near_sin_small _ X N B)) as D.
    injection E; intros E'. rewrite E' in D. rewrite iterate_half in D. exact D.
  Qed.

  Lemma near_cos_sin_model f X c s : near r f X -> cos_sin_model r X = Some (c, s) ->
    near r (fun h => cos (f h)) c /\ near r (fun h => sin (f h)) s.
  Proof.
    intros F. unfold cos_sin_model. set (a := match poly_of X with [] => zero | a :: _ => a end).
    set (D := msub X (constant a)).
    destruct (at_most (round_up (bound r D)) largest_angle) eqn:B; [|discriminate]. destruct (Nat.leb (halvings a) 200); [|discriminate]. simpl.
    destruct (cos_sin_number r a) as [[c0 s0]|] eqn:E; [|discriminate]. intros I; injection I; intros <- <-; clear I.
    destruct (near_cos_sin_number a c0 s0 E) as [C0 S0].
    assert (ND : near r (fun h => f h - value a) D) by (apply near_msub; auto; apply near_constant).
    pose proof (near_cos_small _ D ND B) as C. pose proof (near_sin_small _ D ND B) as S. split.
    - apply (near_ext r (fun h => cos (value a) * cos (f h - value a) - sin (value a) * sin (f h - value a))).
      { intros h. rewrite <- cos_plus. f_equal. ring. }
      apply near_msub; apply (near_mmul r R (fun _ => _)); auto.
    - apply (near_ext r (fun h => sin (value a) * cos (f h - value a) + cos (value a) * sin (f h - value a))).
      { intros h. rewrite <- sin_plus. f_equal. ring. }
      apply near_madd; apply (near_mmul r R (fun _ => _)); auto.
  Qed.

  Lemma near_reciprocal f X : near r f X -> (forall h, Rabs h <= value r -> 1 <= f h) -> near r (fun h => / f h) (reciprocal r X).
  Proof.
    intros F G h H. unfold reciprocal. generalize (guess_reciprocal r X). intros g. cbn [poly_of slack].
    assert (N : near r (fun h => 1 - f h * eval g h) (msub (constant one) (mmul r X (Model g zero)))).
    { apply near_msub; [apply one_near|]. apply (near_mmul r R f); auto. apply near_eval. }
    pose proof (in_bound _ _ h N H) as B. eapply Rle_trans; [|exact B]. specialize (G h H).
    replace (/ f h - eval g h) with (/ f h * (1 - f h * eval g h)) by (field; lra).
    rewrite Rabs_mult. rewrite <- (Rmult_1_l (Rabs (1 - _))) at 2. apply Rmult_le_compat_r; [apply Rabs_pos|].
    rewrite Rabs_right; [|left; apply Rinv_0_lt_compat; lra]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
  Qed.

  Lemma near_reciprocal_root f X M : near r f X -> (forall h, 0 <= f h) -> reciprocal_root r X = Some M ->
    near r (fun h => / sqrt (f h)) M /\ forall h, Rabs h <= value r -> 0 < f h.
  Proof.
    intros F P. unfold reciprocal_root. generalize (guess_root r X). intros g. unfold certified_root.
    cbv zeta. remember (round_up (bound r (msub (constant one) (mmul r X (mmul r (Model g zero) (Model g zero)))))) as residue eqn:D.
    destruct (at_most residue (Number 1 (-1))) eqn:B; [|discriminate].
    destruct (below zero (lower r g)) eqn:L; [|discriminate]. cbn [andb]. intros I; injection I; intros <-; clear I.
    apply at_most_correct in B. apply below_correct in L. rewrite value_zero in L.
    change (Number 1 (-1)) with (Number 1 (- (1))) in B. rewrite value_power in B by lia. change (IZR (2 ^ 1)) with 2 in B.
    assert (N : near r (fun h => 1 - f h * (eval g h * eval g h)) (msub (constant one) (mmul r X (mmul r (Model g zero) (Model g zero))))).
    { apply near_msub; [apply one_near|]. apply (near_mmul r R f (fun h => eval g h * eval g h)); auto.
      apply near_mmul; auto; apply near_eval. }
    assert (Q : forall h, Rabs h <= value r -> Rabs (1 - f h * (eval g h * eval g h)) <= value residue /\ 0 < eval g h /\ 0 < f h).
    { intros h H. pose proof (in_bound _ _ h N H) as Bh. rewrite <- D in Bh. cbv beta in Bh.
      pose proof (lower_correct r g h R H). split; auto. split; [lra|].
      destruct (Req_dec (f h) 0) as [Z|Z]; [|specialize (P h); lra]. rewrite Z, Rmult_0_l, Rminus_0_r, Rabs_R1 in Bh. lra. }
    split; [|intros h H; apply Q; auto]. intros h H. cbn [poly_of slack]. destruct (Q h H) as (E & G & Z).
    eapply Rle_trans; [|apply round_up_correct]. rewrite !value_mul, value_two.
    clear N D Q F. set (x := sqrt (f h)). assert (X0 : 0 < x) by (apply sqrt_lt_R0; auto). assert (XX : x * x = f h) by (apply sqrt_sqrt; lra).
    rewrite <- XX in E. set (y := eval g h) in *.
    assert (Y : y <= value (norm r g)).
    { eapply Rle_trans; [apply Rle_abs|]. apply norm_correct; auto. }
    assert (XY : 0 < x * y) by (apply Rmult_lt_0_compat; auto).
    set (e := value residue) in *. set (ix := / x). assert (IX : ix * x = 1) by (unfold ix; apply Rinv_l; lra).
    assert (IP : 0 < ix) by (apply Rinv_0_lt_compat; auto).
    clearbody x y e ix.
    (* |1 - xy| (1 + xy) <= e, so |1/x - y| <= e / x, and 1/x <= 2 y *)
    assert (E1 : Rabs (1 - x * y) <= e).
    { eapply Rle_trans; [|exact E]. replace (1 - x * x * (y * y)) with ((1 - x * y) * (1 + x * y)) by ring.
      rewrite Rabs_mult. rewrite (Rabs_right (1 + x * y)) by lra. pose proof (Rabs_pos (1 - x * y)). nra. }
    assert (E2 : ix <= 2 * y).
    { assert (1 / 2 <= x * y) by (pose proof (Rle_abs (1 - x * y)); lra). assert (ix * (1 / 2) <= ix * (x * y)) by (apply Rmult_le_compat_l; lra).
      replace (ix * (x * y)) with (ix * x * y) in * by ring. rewrite IX in *. lra. }
    replace (ix - y) with (ix * (1 - x * y)) by (replace (ix * (1 - x * y)) with (ix - ix * x * y) by ring; rewrite IX; ring).
    rewrite Rabs_mult, (Rabs_right ix) by lra. pose proof (Rabs_pos (1 - x * y)).
    assert (ix * Rabs (1 - x * y) <= 2 * y * e) by (apply Rmult_le_compat; lra). assert (0 <= e) by lra.
    assert (e * y <= e * value (norm r g)) by (apply Rmult_le_compat_l; auto). lra.
  Qed.

  Lemma clamp_inside x : -1 <= x <= 1 -> clamp x = x.
  Proof. intros H. unfold clamp. rewrite Rmin_right, Rmax_right; lra. Qed.
  Lemma clamp_range x : -1 <= clamp x <= 1.
  Proof. unfold clamp, Rmax, Rmin. destruct (Rle_dec 1 x); destruct (Rle_dec (-1) _); lra. Qed.
  Lemma clamp_distance x b : Rabs x <= 1 + b -> 0 <= b -> Rabs (clamp x - x) <= b.
  Proof. unfold clamp, Rmax, Rmin. destruct (Rle_dec 1 x); destruct (Rle_dec (-1) _); split_Rabs; lra. Qed.

  Lemma near_clamp f X : near r f X -> near r (fun h => clamp (f h)) (clamp_model r X).
  Proof.
    intros F. unfold clamp_model. set (D := msub (constant one) (mmul r X X)).
    assert (N : near r (fun h => 1 - f h * f h) D) by (apply near_msub; [apply one_near|apply near_mmul; auto]).
    clearbody D. destruct (below (slack D) (lower r (poly_of D))) eqn:B.
    - apply below_correct in B. intros h H. rewrite clamp_inside; auto.
      specialize (N h H). cbv beta in N. pose proof (lower_correct r (poly_of D) h R H).
      assert (0 < 1 - f h * f h) by (split_Rabs; lra). nra.
    - destruct (below zero (sub (bound r X) one)) eqn:E.
      + apply below_correct in E. rewrite value_zero, value_sub, value_one in E. apply (near_widen r f); auto.
        intros h H. rewrite value_sub, value_one. apply clamp_distance; [|lra].
        pose proof (bound_correct r f X h F H). lra.
      + intros h H. replace (clamp (f h)) with (f h); [auto|]. symmetry. apply clamp_inside.
        pose proof (bound_correct r f X h F H) as Q.
        assert (L : value (bound r X) <= 1).
        { destruct (Rle_dec (value (bound r X)) 1); auto. exfalso. apply below_complete in E. rewrite value_zero, value_sub, value_one in E. lra. }
        split_Rabs; lra.
  Qed.

  Lemma near_root f X M : near r f X -> (forall h, 0 <= f h) -> root_model r X = Some M -> near r (fun h => sqrt (f h)) M.
  Proof.
    intros F P. unfold root_model. destruct (reciprocal_root r X) as [i|] eqn:E.
    - intros [= <-]. destruct (near_reciprocal_root _ _ _ F P E) as [I Q].
      intros h H. replace (sqrt (f h)) with (f h * / sqrt (f h)).
      + apply (near_mmul r R f (fun h => / sqrt (f h))); auto.
      + specialize (Q h H). pose proof (sqrt_lt_R0 _ Q). rewrite <- (sqrt_sqrt (f h)) at 1 by lra. field. lra.
    - destruct (at_most zero (root_above (round_up (bound r X)))) eqn:A; [|discriminate].
      destruct (at_most (round_up (bound r X)) _) eqn:B; [|discriminate]. cbn [andb]. intros [= <-].
      apply at_most_correct in A, B. rewrite value_zero in A. rewrite value_mul in B. intros h H.
      cbn [poly_of slack eval]. rewrite value_half. set (s := value (root_above _)) in *.
      pose proof (in_bound f X h F H) as Q. pose proof (P h). rewrite Rabs_right in Q by lra.
      pose proof (sqrt_pos (f h)). assert (sqrt (f h) <= s).
      { rewrite <- (sqrt_square s) by lra. apply sqrt_le_1; nra. }
      apply Rabs_le. lra.
  Qed.
End Correctness.
