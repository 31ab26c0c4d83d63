(** Models of functions: a polynomial, and by how much the function is off it at most, for all |h| up to a radius
    (Taylor models, after Makino and Berz). *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
From Taut Require Import Definitions Numbers.
Import ListNotations.
Open Scope R_scope.

(** * Polynomials *)

Definition poly := list number.

Fixpoint padd (p q : poly) : poly :=
  match p, q with [], _ => q | _, [] => p | a :: p', b :: q' => add a b :: padd p' q' end.
Definition pneg (p : poly) : poly := map neg p.
Definition pscale (a : number) (p : poly) : poly := map (mul a) p.
Fixpoint pmul (p q : poly) : poly := match p with [] => [] | a :: p' => padd (pscale a q) (zero :: pmul p' q) end.
(** p(d + h) *)
Fixpoint pshift (d : number) (p : poly) : poly :=
  match p with [] => [] | a :: p' => let q := pshift d p' in padd [a] (padd (pscale d q) (zero :: q)) end.
(** A bound of |p(h)| for |h| <= r. *)
Definition norm (r : number) (p : poly) : number := fold_right (fun a b => round_up (add (size a) (mul r b))) zero p.
(** A lower bound of p(h) for |h| <= r, where even powers with positive coefficients count as zero. *)
Fixpoint tail_deficit (even : bool) (r : number) (p : poly) : number :=
  match p with
  | [] => zero
  | a :: p' => let d := tail_deficit (negb even) r p' in
               round_up (add (if even && at_most zero a then zero else size a) (mul r d))
  end.
Definition lower (r : number) (p : poly) : number :=
  match p with [] => zero | a :: p' => sub a (mul r (tail_deficit false r p')) end.

Lemma eval_padd p q x : eval (padd p q) x = eval p x + eval q x.
Proof. revert q; induction p as [|a p IH]; intros [|b q]; simpl; try ring. rewrite IH, value_add. ring. Qed.
Lemma eval_pneg p x : eval (pneg p) x = - eval p x.
Proof. induction p as [|a p IH]; simpl; [ring|]. rewrite IH, value_neg. ring. Qed.
Lemma eval_pscale a p x : eval (pscale a p) x = value a * eval p x.
Proof. induction p as [|b p IH]; simpl; [ring|]. rewrite IH, value_mul. ring. Qed.
Lemma eval_pmul p q x : eval (pmul p q) x = eval p x * eval q x.
Proof. induction p as [|a p IH]; simpl; [ring|]. rewrite eval_padd, eval_pscale. simpl. rewrite IH, value_zero. ring. Qed.
Lemma eval_cons a p x : eval (a :: p) x = value a + x * eval p x.
Proof. reflexivity. Qed.
Lemma eval_pshift d p h : eval (pshift d p) h = eval p (value d + h).
Proof.
  induction p as [|a p IH]; [reflexivity|]. cbn [pshift].
  rewrite !eval_padd, eval_pscale, !eval_cons, IH, value_zero. simpl. ring.
Qed.

Lemma norm_correct r p h : Rabs h <= value r -> Rabs (eval p h) <= value (norm r p).
Proof.
  intros H. induction p as [|a p IH]; simpl; [rewrite Rabs_R0, value_zero; lra|].
  eapply Rle_trans; [|apply round_up_correct]. rewrite value_add, value_mul, value_size.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult. apply Rplus_le_compat_l.
  apply Rmult_le_compat; auto using Rabs_pos.
Qed.

Lemma norm_nonneg r p : 0 <= value r -> 0 <= value (norm r p).
Proof.
  intros H. apply Rle_trans with (Rabs (eval p 0)); [apply Rabs_pos|]. apply norm_correct. rewrite Rabs_R0. auto.
Qed.

Lemma tail_deficit_correct r p h : 0 <= value r -> Rabs h <= value r -> forall (even : bool) w,
  (if even then 0 <= w else 0 <= w * h) ->
  - (Rabs w * value (tail_deficit even r p)) <= w * eval p h /\ 0 <= value (tail_deficit even r p).
Proof.
  intros R H. induction p as [|a p IH]; intros even w E; simpl; [rewrite value_zero; lra|].
  set (d := tail_deficit (negb even) r p) in *. set (c := if even && at_most zero a then zero else size a).
  pose proof (round_up_correct (add c (mul r d))) as U. rewrite value_add, value_mul in U.
  destruct (IH (negb even) (w * h)) as [L D]; [destruct even; simpl; nra|]. fold d in L, D.
  assert (C : - (Rabs w * value c) <= w * value a /\ 0 <= value c).
  { assert (G : - (Rabs w * Rabs (value a)) <= w * value a).
    { rewrite <- Rabs_mult. pose proof (Rle_abs (- (w * value a))) as B. rewrite Rabs_Ropp in B. lra. }
    unfold c. destruct even; simpl; [|rewrite value_size; split; auto using Rabs_pos].
    destruct (at_most zero a) eqn:A; [|rewrite value_size; split; auto using Rabs_pos].
    apply at_most_correct in A. rewrite value_zero in *. split; [|lra]. assert (0 <= w * value a) by nra. lra. }
  pose proof (Rabs_pos w) as W. pose proof (Rabs_pos h) as P.
  assert (M : Rabs (w * h) * value d <= Rabs w * (value r * value d)).
  { rewrite Rabs_mult, Rmult_assoc. apply Rmult_le_compat_l; auto. apply Rmult_le_compat_r; auto. }
  assert (N : 0 <= value r * value d) by (apply Rmult_le_pos; auto).
  split; [|lra]. replace (w * (value a + h * eval p h)) with (w * value a + w * h * eval p h) by ring.
  assert (Rabs w * (value c + value r * value d) <= Rabs w * value (round_up (add c (mul r d))))
    by (apply Rmult_le_compat_l; auto). lra.
Qed.

Lemma lower_correct r p h : 0 <= value r -> Rabs h <= value r -> value (lower r p) <= eval p h.
Proof.
  intros R H. destruct p as [|a p]; simpl; [rewrite value_zero; lra|]. rewrite value_sub, value_mul.
  destruct (tail_deficit_correct r p h R H false h) as [L D]; [nra|].
  assert (Rabs h * value (tail_deficit false r p) <= value r * value (tail_deficit false r p))
    by (apply Rmult_le_compat_r; auto). lra.
Qed.

(** * Models *)

Record model := Model { poly_of : poly; slack : number }.

(** M is a model of f for |h| <= r. *)
Definition near (r : number) (f : R -> R) (M : model) : Prop :=
  forall h, Rabs h <= value r -> Rabs (f h - eval (poly_of M) h) <= value (slack M).

(** Terms that matter, of limited length; the rest goes to the slack. Any number of terms would do. *)
Fixpoint trim (bits : Z) (k : nat) (r : number) (p : poly) : poly * number :=
  match p with
  | [] => ([], zero)
  | a :: p' =>
      match k with
      | O => ([], norm r p)
      | S k' => let (b, e) := cut bits a in let (q, e') := trim bits k' r p' in (b :: q, add e (mul r e'))
      end
  end.
Definition most_terms := 8%nat.
Definition negligible := 60%Z.
Definition magnitude (a : number) : Z := (Z.log2 (Z.abs (mantissa a)) + exponent a)%Z.
(** The largest magnitude of a term, where those of powers of h have [step] added for each. *)
Fixpoint largest (step shift best : Z) (p : poly) : Z :=
  match p with
  | [] => best
  | a :: p' => largest step (shift + step) (if Z.eqb (mantissa a) 0 then best else Z.max best (magnitude a + shift)) p'
  end.
Fixpoint terms_above (step shift floor : Z) (p : poly) : nat :=
  match p with
  | [] => O
  | a :: p' =>
      match terms_above step (shift + step) floor p' with
      | S n => S (S n)
      | O => if Z.eqb (mantissa a) 0 || Z.leb (magnitude a + shift) floor then O else 1%nat
      end
  end.
Definition useful (negligible : Z) (r : number) (p : poly) : nat :=
  match p with
  | [] => O
  | a :: _ =>
      if Z.eqb (mantissa r) 0 then 1%nat
      else let step := (magnitude r + 1)%Z in
           Nat.min most_terms (terms_above step 0 (largest step 0 (magnitude a) p - negligible) p)
  end.
Definition shorter (bits negligible : Z) (r : number) (M : model) : model :=
  let (p, e) := trim bits (useful negligible r (poly_of M)) r (poly_of M) in Model p (round_up (add (slack M) e)).
Definition tidy (r : number) (M : model) : model := shorter kept_bits negligible r M.

Definition constant (a : number) : model := Model [a] zero.
Definition variable : model := Model [zero; one] zero.
Definition madd (M N : model) : model := Model (padd (poly_of M) (poly_of N)) (round_up (add (slack M) (slack N))).
Definition mneg (M : model) : model := Model (pneg (poly_of M)) (slack M).
Definition msub (M N : model) : model := madd M (mneg N).
Definition mscale (a : number) (M : model) : model := Model (pscale a (poly_of M)) (round_up (mul (size a) (slack M))).
(** A bound of the modelled function. *)
Definition bound (r : number) (M : model) : number := add (norm r (poly_of M)) (slack M).
Definition mmul (r : number) (M N : model) : model :=
  tidy r (Model (pmul (poly_of M) (poly_of N))
                (add (mul (slack M) (bound r N)) (mul (norm r (poly_of M)) (slack N)))).

Section Correctness.
  Variable r : number.
  Hypothesis R : 0 <= value r.

  Lemma near_ext f g M : (forall h, f h = g h) -> near r f M -> near r g M.
  Proof. intros E H h Hh. rewrite <- E. auto. Qed.

  Lemma slack_nonneg f M : near r f M -> 0 <= value (slack M).
  Proof. intros H. eapply Rle_trans; [apply Rabs_pos|]. apply (H 0). rewrite Rabs_R0. auto. Qed.

  Lemma trim_correct bits k p h : Rabs h <= value r ->
    Rabs (eval p h - eval (fst (trim bits k r p)) h) <= value (snd (trim bits k r p)).
  Proof.
    intros H. revert k; induction p as [|a p IH]; intros k.
    - destruct k; simpl; rewrite value_zero, Rminus_diag_eq, Rabs_R0 by auto; lra.
    - destruct k as [|k]; cbn [trim].
      + cbn [fst snd]. change (eval [] h) with 0. rewrite Rminus_0_r. apply norm_correct; auto.
      + pose proof (cut_correct bits a) as C. destruct (cut bits a) as [b e]. specialize (IH k). destruct (trim bits k r p) as [q e'].
        cbn [fst snd eval] in *. rewrite value_add, value_mul.
        replace (value a + h * eval p h - (value b + h * eval q h)) with (value a - value b + h * (eval p h - eval q h)) by ring.
        eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult. apply Rplus_le_compat; auto.
        apply Rmult_le_compat; auto using Rabs_pos.
  Qed.

  Lemma near_shorter bits few f M : near r f M -> near r f (shorter bits few r M).
  Proof.
    intros H h Hh. unfold shorter. pose proof (trim_correct bits (useful few r (poly_of M)) (poly_of M) h Hh) as T.
    destruct (trim bits (useful few r (poly_of M)) r (poly_of M)) as [p e]. cbn [poly_of slack fst snd] in *.
    eapply Rle_trans; [|apply round_up_correct]. rewrite value_add. specialize (H h Hh).
    replace (f h - eval p h) with (f h - eval (poly_of M) h + (eval (poly_of M) h - eval p h)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. lra.
  Qed.
  Lemma near_tidy f M : near r f M -> near r f (tidy r M).
  Proof. apply near_shorter. Qed.

  Lemma near_constant a : near r (fun _ => value a) (constant a).
  Proof. intros h _. simpl. rewrite value_zero. replace (_ - _) with 0 by ring. rewrite Rabs_R0. lra. Qed.
  Lemma near_variable : near r (fun h => h) variable.
  Proof. intros h _. simpl. rewrite value_zero, value_one. replace (_ - _) with 0 by ring. rewrite Rabs_R0. lra. Qed.
  Lemma near_eval p : near r (eval p) (Model p zero).
  Proof. intros h _. simpl. rewrite Rminus_diag_eq, Rabs_R0, value_zero by auto. lra. Qed.

  Lemma near_madd f g M N : near r f M -> near r g N -> near r (fun h => f h + g h) (madd M N).
  Proof.
    intros F G h Hh. simpl. eapply Rle_trans; [|apply round_up_correct]. rewrite eval_padd, value_add.
    specialize (F h Hh). specialize (G h Hh).
    replace (_ - _) with (f h - eval (poly_of M) h + (g h - eval (poly_of N) h)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. lra.
  Qed.
  Lemma near_mneg f M : near r f M -> near r (fun h => - f h) (mneg M).
  Proof.
    intros F h Hh. simpl. rewrite eval_pneg. replace (_ - _) with (- (f h - eval (poly_of M) h)) by ring.
    rewrite Rabs_Ropp. auto.
  Qed.
  Lemma near_msub f g M N : near r f M -> near r g N -> near r (fun h => f h - g h) (msub M N).
  Proof. intros F G. apply (near_madd f (fun h => - g h)); auto. apply near_mneg; auto. Qed.
  Lemma near_mscale a f M : near r f M -> near r (fun h => value a * f h) (mscale a M).
  Proof.
    intros F h Hh. simpl. eapply Rle_trans; [|apply round_up_correct]. rewrite eval_pscale, value_mul, value_size.
    replace (_ - _) with (value a * (f h - eval (poly_of M) h)) by ring. rewrite Rabs_mult.
    apply Rmult_le_compat_l; auto using Rabs_pos.
  Qed.
  Lemma bound_correct f M h : near r f M -> Rabs h <= value r -> Rabs (f h) <= value (bound r M).
  Proof.
    intros F Hh. unfold bound. rewrite value_add. specialize (F h Hh). pose proof (norm_correct r (poly_of M) h Hh).
    replace (f h) with (eval (poly_of M) h + (f h - eval (poly_of M) h)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. lra.
  Qed.
  Lemma near_mmul f g M N : near r f M -> near r g N -> near r (fun h => f h * g h) (mmul r M N).
  Proof.
    intros F G. apply near_tidy. intros h Hh. simpl. rewrite eval_pmul, value_add, !value_mul.
    pose proof (bound_correct g N h G Hh). pose proof (norm_correct r (poly_of M) h Hh).
    pose proof (slack_nonneg f M F). pose proof (norm_nonneg r (poly_of M) R). specialize (F h Hh). specialize (G h Hh).
    replace (_ - _) with ((f h - eval (poly_of M) h) * g h + eval (poly_of M) h * (g h - eval (poly_of N) h)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
    apply Rplus_le_compat; apply Rmult_le_compat; auto using Rabs_pos.
  Qed.
End Correctness.
