(** Arithmetic of numbers m * 2^e, exact but for [cut], which says by how much it is off. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
From Taut Require Import Definitions.
Open Scope R_scope.

Definition zero := Number 0 0.
Definition one := Number 1 0.

Definition add (a b : number) : number :=
  if Z.eqb (mantissa a) 0 then b else if Z.eqb (mantissa b) 0 then a else
  if Z.leb (exponent a) (exponent b)
  then Number (mantissa a + Z.shiftl (mantissa b) (exponent b - exponent a)) (exponent a)
  else Number (Z.shiftl (mantissa a) (exponent a - exponent b) + mantissa b) (exponent b).
Definition neg (a : number) : number := Number (- mantissa a) (exponent a).
Definition sub (a b : number) : number := add a (neg b).
Definition mul (a b : number) : number := Number (mantissa a * mantissa b) (exponent a + exponent b).
Definition size (a : number) : number := Number (Z.abs (mantissa a)) (exponent a).
Definition half (a : number) : number := Number (mantissa a) (exponent a - 1).
(** a < b, a <= b *)
Definition below (a b : number) : bool := Z.ltb 0 (mantissa (sub b a)).
Definition at_most (a b : number) : bool := Z.leb 0 (mantissa (sub b a)).

(* By names, so that the program has them ready. *)
Definition kept_bits := 96%Z.
Definition slack_bits := 30%Z.
Definition vertex_bits := 26%Z.

(** At most so many bits of a number, and how much is left out at most. *)
Definition cut (bits : Z) (a : number) : number * number :=
  let n := Z.log2 (Z.abs (mantissa a)) in
  if Z.leb n bits then (a, zero)
  else let k := (n - bits)%Z in
       (Number (Z.shiftr (mantissa a) k) (exponent a + k), Number 1 (exponent a + k)).
(** Not less, in few bits. *)
Definition round_up (a : number) : number :=
  let n := Z.log2 (Z.abs (mantissa a)) in
  if Z.leb n slack_bits then a
  else let k := (n - slack_bits)%Z in Number (Z.shiftr (mantissa a) k + 1) (exponent a + k).

Lemma two_pos e : 0 < powerRZ 2 e.
Proof. apply powerRZ_lt; lra. Qed.

Lemma two_add a b : powerRZ 2 (a + b) = powerRZ 2 a * powerRZ 2 b.
Proof. apply powerRZ_add; lra. Qed.

Lemma two_nat k : (0 <= k)%Z -> powerRZ 2 k = IZR (2 ^ k).
Proof. intros H. rewrite <- (Z2Nat.id k) by lia. rewrite <- pow_powerRZ, pow_IZR. rewrite Z2Nat.id by lia. reflexivity. Qed.

Lemma shiftl_value m k : (0 <= k)%Z -> IZR (Z.shiftl m k) = IZR m * powerRZ 2 k.
Proof. intros H. rewrite Z.shiftl_mul_pow2, mult_IZR, two_nat by lia. reflexivity. Qed.

Lemma value_zero : value zero = 0.
Proof. unfold value; simpl; ring. Qed.
Lemma value_one : value one = 1.
Proof. unfold value; simpl; ring. Qed.

Lemma value_add a b : value (add a b) = value a + value b.
Proof.
  unfold add. destruct (Z.eqb_spec (mantissa a) 0) as [E|_]; [unfold value; rewrite E; ring|].
  destruct (Z.eqb_spec (mantissa b) 0) as [E|_]; [unfold value; rewrite E; ring|].
  destruct (Z.leb_spec (exponent a) (exponent b)); unfold value; simpl; rewrite plus_IZR, shiftl_value by lia.
  - replace (exponent b) with (exponent b - exponent a + exponent a)%Z at 2 by lia. rewrite two_add. ring.
  - replace (exponent a) with (exponent a - exponent b + exponent b)%Z at 2 by lia. rewrite two_add. ring.
Qed.
Lemma value_neg a : value (neg a) = - value a.
Proof. unfold value; simpl. rewrite opp_IZR. ring. Qed.
Lemma value_sub a b : value (sub a b) = value a - value b.
Proof. unfold sub. rewrite value_add, value_neg. ring. Qed.
Lemma value_mul a b : value (mul a b) = value a * value b.
Proof. unfold value; simpl. rewrite mult_IZR, two_add. ring. Qed.
Lemma value_size a : value (size a) = Rabs (value a).
Proof.
  unfold value; simpl. rewrite abs_IZR, Rabs_mult. f_equal. symmetry. apply Rabs_right. left. apply two_pos.
Qed.
Lemma value_half a : value (half a) = value a / 2.
Proof. unfold value, half; simpl mantissa; simpl exponent. unfold Z.sub. rewrite two_add. simpl powerRZ at 2. field. Qed.

Lemma value_sign_pos a : (0 < mantissa a)%Z -> 0 < value a.
Proof. intros H. apply Rmult_lt_0_compat; [apply (IZR_lt 0); auto|apply two_pos]. Qed.
Lemma value_nonzero a : mantissa a <> 0%Z -> value a <> 0.
Proof. intros H E. unfold value in E. apply Rmult_integral in E. pose proof (two_pos (exponent a)). destruct E as [E|E]; [apply (eq_IZR _ 0) in E; auto|lra]. Qed.
Lemma value_sign_nonneg a : (0 <= mantissa a)%Z -> 0 <= value a.
Proof. intros H. apply Rmult_le_pos; [apply (IZR_le 0); auto|left; apply two_pos]. Qed.

Lemma below_correct a b : below a b = true -> value a < value b.
Proof. unfold below. intros H. apply Z.ltb_lt, value_sign_pos in H. rewrite value_sub in H. lra. Qed.
Lemma below_complete a b : below a b = false -> value b <= value a.
Proof.
  unfold below. intros H. apply Z.ltb_ge in H. assert (L : value (sub b a) <= 0).
  { unfold value. pose proof (two_pos (exponent (sub b a))). apply (IZR_le _ 0) in H. nra. }
  rewrite value_sub in L. lra.
Qed.
Lemma at_most_correct a b : at_most a b = true -> value a <= value b.
Proof. unfold at_most. intros H. apply Z.leb_le, value_sign_nonneg in H. rewrite value_sub in H. lra. Qed.

Lemma shiftr_bounds m k : (0 <= k)%Z -> IZR (Z.shiftr m k) * powerRZ 2 k <= IZR m < (IZR (Z.shiftr m k) + 1) * powerRZ 2 k.
Proof.
  intros H. rewrite Z.shiftr_div_pow2, two_nat by lia. rewrite <- plus_IZR, <- !mult_IZR.
  assert (P : (0 < 2 ^ k)%Z) by (apply Z.pow_pos_nonneg; lia).
  pose proof (Z.div_mod m (2 ^ k) ltac:(lia)). pose proof (Z.mod_pos_bound m (2 ^ k) P).
  split; [apply IZR_le|apply IZR_lt]; nia.
Qed.

Lemma cut_correct bits a : Rabs (value a - value (fst (cut bits a))) <= value (snd (cut bits a)).
Proof.
  unfold cut. destruct (Z.leb_spec (Z.log2 (Z.abs (mantissa a))) bits) as [_|H]; simpl.
  - rewrite value_zero. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
  - set (k := (Z.log2 (Z.abs (mantissa a)) - bits)%Z) in *. destruct (shiftr_bounds (mantissa a) k) as [L U]; [lia|].
    unfold value; simpl mantissa; simpl exponent. rewrite two_add. pose proof (two_pos (exponent a)). pose proof (two_pos k).
    apply Rabs_le. split; nra.
Qed.

Lemma round_up_correct a : value a <= value (round_up a).
Proof.
  unfold round_up. destruct (Z.leb_spec (Z.log2 (Z.abs (mantissa a))) slack_bits) as [_|H]; [lra|].
  set (k := (Z.log2 (Z.abs (mantissa a)) - slack_bits)%Z) in *. destruct (shiftr_bounds (mantissa a) k) as [_ U]; [lia|].
  unfold value; simpl mantissa; simpl exponent. rewrite two_add, plus_IZR. pose proof (two_pos (exponent a)). nra.
Qed.

Global Opaque add neg sub mul size half below at_most cut round_up.
Global Opaque value.
