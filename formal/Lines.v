(** Whether boxes and vertices are beyond a line throughout a window, in whole numbers. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
From Taut Require Import Definitions Numbers Models Placement Outlines Whole.
Import ListNotations.
Open Scope R_scope.

(** From the level on along the direction: base + x per_x + y per_y for each power of u. *)
Definition term := (Z * (Z * Z))%type.
Fixpoint line_terms (j k nx ny : Z) (l : list ((Z * Z) * (Z * Z))) (level : list Z) : list term :=
  match l with
  | [] => map (fun v => (- v, (0, 0))%Z) level
  | (p, q) :: l =>
      let (v, level) := match level with [] => (0%Z, []) | v :: level => (v, level) end in
      ((Z.shiftr (nx * fst p + ny * snd p) j - v, (Z.shiftr (nx * fst q + ny * snd q) k, Z.shiftr (ny * fst q - nx * snd q) k))%Z)
        :: line_terms j k nx ny l level
  end.

(** What has to be left: for the errors of a vertex in the box, and for each step away from the middle of a smaller box. *)
Record whole_line := WholeLine { terms : list term; room : Z; room_x : Z; room_y : Z }.
Definition reach (s : span) : Z := (Z.abs (fst s) + snd s)%Z.
Definition size_x (l : list term) : Z := fold_right (fun t s => (Z.abs (fst (snd t)) + s)%Z) 0%Z l.
Definition size_y (l : list term) : Z := fold_right (fun t s => (Z.abs (snd (snd t)) + s)%Z) 0%Z l.
Definition whole_line_of (g : Z) (r : number) (n : number * number) (level : poly) (W : whole_placement) (b : box) : whole_line :=
  let e := Z.min (exponent (fst n)) (exponent (snd n)) in
  let nx := whole e (fst n) in let ny := whole e (snd n) in
  let size := (Z.abs nx + Z.abs ny)%Z in
  let k := Z.log2 size in
  let j := (k - (turn_bits - place_bits))%Z in
  let v := scaled (e + k + g - turn_bits) one r level in
  let l := line_terms j k nx ny (coefficients W) v in
  let n_terms := count l in
  let off_base := (Z.shiftr (size * off_place W) j + 1 + 2 * n_terms)%Z in
  let off_along := (Z.shiftr (size * off_turn W) k + 1 + n_terms)%Z in
  let sx := (size_x l + off_along)%Z in let sy := (size_y l + off_along)%Z in
  WholeLine l (off_base + (reach (fst b) + reach (snd b)) * off_along + sx + sy) sx sy.

Fixpoint deficit (even : bool) (x y : Z) (l : list term) : Z :=
  match l with
  | [] => 0
  | (b, (c, d)) :: l =>
      let v := (b + (x * c + y * d))%Z in
      let rest := deficit (negb even) x y l in
      if even && Z.leb 0 v then rest else (Z.abs v + rest)%Z
  end.
Definition lowest (x y : Z) (l : list term) : Z :=
  match l with [] => 0 | (b, (c, d)) :: l => (b + (x * c + y * d) - deficit false x y l)%Z end.
Definition cell_beyond (L : whole_line) (c : cell) : bool := Z.ltb (room L) (lowest (fst c) (snd c) (terms L)).
Definition box_beyond (L : whole_line) (b : box) : bool :=
  Z.ltb (room L + (snd (fst b) * room_x L + snd (snd b) * room_y L)) (lowest (fst (fst b)) (fst (snd b)) (terms L)).
Fixpoint tree_beyond (L : whole_line) (t : tree) : bool :=
  match t with
  | Empty => true
  | Leaf _ _ c d => cell_beyond L c && cell_beyond L d
  | Node b t1 t2 => box_beyond L b || (tree_beyond L t1 && tree_beyond L t2)
  end.

(** * Correctness *)

Lemma line_terms_along j k nx ny l u : Rabs u <= 1 -> forall level,
  let s := line_terms j k nx ny l level in let c := powerRZ 2 k in
  Rabs (IZR nx * series (fun q => fst (snd q)) l u + IZR ny * series (fun q => snd (snd q)) l u - series (fun t => fst (snd t)) s u * c)
    <= IZR (count s) * c /\
  Rabs (IZR ny * series (fun q => fst (snd q)) l u - IZR nx * series (fun q => snd (snd q)) l u - series (fun t => snd (snd t)) s u * c)
    <= IZR (count s) * c.
Proof.
  intros U. pose proof (two_pos k) as P. cbv zeta. induction l as [|[p q] l IH]; intros level.
  - cbn [line_terms series]. rewrite !series_const by auto.
    assert (0 <= IZR (count (map (fun v => (- v, (0, 0))%Z) level)) * powerRZ 2 k)
      by (apply Rmult_le_pos; [apply (IZR_le 0); apply count_nonneg|lra]).
    split; replace (_ - _) with 0 by ring; rewrite Rabs_R0; auto.
  - cbn [line_terms]. destruct (match level with [] => (0%Z, []) | v :: level => (v, level) end) as [v level'].
    specialize (IH level'). set (rest := line_terms j k nx ny l level') in *. destruct IH as [X Y].
    cbn [series count fst snd]. rewrite plus_IZR. set (c := powerRZ 2 k) in *.
    pose proof (shiftr_close (nx * fst q + ny * snd q) k) as SX. pose proof (shiftr_close (ny * fst q - nx * snd q) k) as SY.
    rewrite plus_IZR, !mult_IZR in SX. rewrite minus_IZR, !mult_IZR in SY. fold c in SX, SY.
    rewrite (Rmult_plus_distr_r 1), Rmult_1_l.
    split; match goal with
           | |- Rabs (?n * (?a + u * ?x) + ?m * (?b + u * ?y) - (?z + u * ?w) * c) <= _ =>
               replace (_ - _) with (n * a + m * b + u * (n * x + m * y) - (z * c + u * (w * c))) by ring
           | |- Rabs (?n * (?a + u * ?x) - ?m * (?b + u * ?y) - (?z + u * ?w) * c) <= _ =>
               replace (_ - _) with (n * a - m * b + u * (n * x - m * y) - (z * c + u * (w * c))) by ring
           end; apply horner_step; auto.
Qed.

Lemma line_terms_base j k nx ny l u : Rabs u <= 1 -> forall level,
  let s := line_terms j k nx ny l level in let c := powerRZ 2 j in
  Rabs (IZR nx * series (fun q => fst (fst q)) l u + IZR ny * series (fun q => snd (fst q)) l u -
        (series fst s u + series self level u) * c) <= IZR (count s) * c.
Proof.
  intros U. pose proof (two_pos j) as P. cbv zeta. induction l as [|[p q] l IH]; intros level.
  - cbn [line_terms series].
    assert (E : series fst (map (fun v => (- v, (0, 0))%Z) level) u = - series self level u)
      by (induction level; cbn [map series fst]; [ring|rewrite IHlevel, opp_IZR; unfold self; ring]).
    rewrite E. replace (_ - _) with 0 by ring. rewrite Rabs_R0.
    apply Rmult_le_pos; [apply (IZR_le 0); apply count_nonneg|lra].
  - cbn [line_terms]. set (next := match level with [] => (0%Z, []) | v :: level => (v, level) end).
    assert (E : series self level u = IZR (fst next) + u * series self (snd next) u)
      by (unfold next, self; destruct level; cbn [series fst snd]; ring). rewrite E.
    destruct next as [v level']. specialize (IH level'). cbn [fst snd].
    set (rest := line_terms j k nx ny l level') in *. cbn [series count fst snd]. rewrite plus_IZR. set (c := powerRZ 2 j) in *.
    pose proof (shiftr_close (nx * fst p + ny * snd p) j) as S. rewrite plus_IZR, !mult_IZR in S. fold c in S.
    rewrite (Rmult_plus_distr_r 1), Rmult_1_l, minus_IZR.
    match goal with |- Rabs (?n * (?a + u * ?x) + ?m * (?b + u * ?y) - (?z - ?v + u * ?w + (?v + u * ?w')) * c) <= _ =>
      replace (_ - _) with (n * a + m * b + u * (n * x + m * y) - (z * c + u * ((w + w') * c))) by ring end.
    apply horner_step; auto.
Qed.

(** * What lines and boxes say *)

(** At u, of the point (x, y) of the grid. *)
Definition along_terms (x y : R) (l : list term) (u : R) : R :=
  series fst l u + (x * series (fun t => fst (snd t)) l u + y * series (fun t => snd (snd t)) l u).

Lemma along_terms_cons x y b c d l u :
  along_terms (IZR x) (IZR y) ((b, (c, d)) :: l) u = IZR (b + (x * c + y * d)) + u * along_terms (IZR x) (IZR y) l u.
Proof. unfold along_terms. cbn [series fst snd]. rewrite !plus_IZR, !mult_IZR. ring. Qed.

Lemma deficit_correct x y l u : Rabs u <= 1 -> forall (even : bool) w, Rabs w <= 1 -> (if even then 0 <= w else 0 <= w * u) ->
  - IZR (deficit even x y l) <= w * along_terms (IZR x) (IZR y) l u.
Proof.
  intros U. induction l as [|[b [c d]] l IH]; intros even w W E; [unfold along_terms; simpl; lra|].
  rewrite along_terms_cons. cbn [deficit]. set (v := (b + (x * c + y * d))%Z). set (z := along_terms (IZR x) (IZR y) l u) in *.
  assert (N : Rabs (w * u) <= 1) by (rewrite Rabs_mult; pose proof (Rabs_pos w); pose proof (Rabs_pos u); nra).
  assert (I : - IZR (deficit (negb even) x y l) <= w * u * z) by (apply IH; auto; destruct even; simpl; nra).
  replace (w * (IZR v + u * z)) with (w * IZR v + w * u * z) by ring.
  destruct (even && Z.leb 0 v) eqn:C.
  - apply andb_prop in C. destruct C as [-> C]. apply Z.leb_le, (IZR_le 0) in C. assert (0 <= w * IZR v) by (apply Rmult_le_pos; auto). lra.
  - rewrite plus_IZR, abs_IZR. assert (A : Rabs (w * IZR v) <= 1 * Rabs (IZR v)).
    { rewrite Rabs_mult. apply Rmult_le_compat_r; auto using Rabs_pos. }
    apply Rabs_within in A. lra.
Qed.

Lemma lowest_correct x y l u : Rabs u <= 1 -> IZR (lowest x y l) <= along_terms (IZR x) (IZR y) l u.
Proof.
  intros U. destruct l as [|[b [c d]] l]; [unfold along_terms; simpl; lra|]. rewrite along_terms_cons. cbn [lowest].
  pose proof (deficit_correct x y l u U false u U ltac:(nra)). rewrite minus_IZR. lra.
Qed.

Lemma series_size {A} (f : A -> Z) l u : Rabs u <= 1 -> Rabs (series f l u) <= IZR (fold_right (fun a s => (Z.abs (f a) + s)%Z) 0%Z l).
Proof.
  intros U. induction l as [|a l IH]; cbn [series fold_right]; [rewrite Rabs_R0; lra|]. rewrite plus_IZR, abs_IZR.
  replace (IZR (f a) + u * series f l u) with (IZR (f a) + u * series f l u - (0 + u * 0)) by ring.
  apply horner_step; auto; rewrite Rminus_0_r; auto. lra.
Qed.

Lemma count_line_terms j k nx ny l : forall level, (count level <= count (line_terms j k nx ny l level))%Z.
Proof.
  assert (M : forall A B (m : A -> B) l, count (map m l) = count l) by (induction l0; cbn [map count]; congruence).
  induction l as [|[p q] l IH]; intros level; cbn [line_terms]; [rewrite M; lia|].
  destruct level as [|v level]; cbn [count]; specialize (IH level) || specialize (IH []); cbn [count] in *; lia.
Qed.

Transparent value.
Lemma whole_exact e a : (e <= exponent a)%Z -> value a = IZR (whole e a) * powerRZ 2 e.
Proof.
  intros H. unfold value, whole. rewrite shiftl_value by lia. rewrite Rmult_assoc, <- two_add.
  replace (exponent a - e + e)%Z with (exponent a) by lia. reflexivity.
Qed.
Global Opaque value.

Lemma shiftr_above m k : IZR m <= (IZR (Z.shiftr m k) + 1) * powerRZ 2 k.
Proof. pose proof (shiftr_close m k) as H. apply Rabs_within in H. lra. Qed.

(** Two products with numbers, and what the factors are off. *)
Lemma two_products nx ny a b x y s off : Rabs (a - x * s) <= off * s -> Rabs (b - y * s) <= off * s ->
  Rabs (nx * a + ny * b - (nx * x + ny * y) * s) <= (Rabs nx + Rabs ny) * off * s.
Proof.
  intros A B. replace (_ - _) with (nx * (a - x * s) + ny * (b - y * s)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. pose proof (Rabs_pos nx). pose proof (Rabs_pos ny).
  assert (Rabs nx * Rabs (a - x * s) <= Rabs nx * (off * s)) by (apply Rmult_le_compat_l; auto).
  assert (Rabs ny * Rabs (b - y * s) <= Rabs ny * (off * s)) by (apply Rmult_le_compat_l; auto). lra.
Qed.

(** With a vertex of the grid for the vertex, and a rounded value along a direction. *)
Lemma vertex_product v c G a x Kq e z m : 0 < G -> 0 < Kq -> Rabs (v - c * G) <= G -> Rabs (a - x * Kq) <= e * Kq -> Rabs x <= z ->
  Rabs c <= m -> 0 <= e -> Rabs (v * a - c * x * (G * Kq)) <= (m * e + (z + e)) * (G * Kq).
Proof.
  intros PG PK V A X M E. replace (_ - _) with ((v - c * G) * a + c * (G * (a - x * Kq))) by ring.
  assert (B : Rabs a <= (z + e) * Kq).
  { replace a with (x * Kq + (a - x * Kq)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult, (Rabs_right Kq) by lra.
    assert (Rabs x * Kq <= z * Kq) by (apply Rmult_le_compat_r; lra). lra. }
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, (Rabs_right G) by lra.
  assert (Rabs (v - c * G) * Rabs a <= G * ((z + e) * Kq)) by (apply Rmult_le_compat; auto using Rabs_pos).
  assert (Rabs c * (G * Rabs (a - x * Kq)) <= m * (G * (e * Kq))).
  { apply Rmult_le_compat; auto using Rabs_pos; [apply Rmult_le_pos; auto using Rabs_pos; lra|]. apply Rmult_le_compat_l; lra. }
  lra.
Qed.

Lemma line_bound p K G q o J X Y C S QX QY QC QS op ot nx ny sp st cl cv SB SV SX SY lev zx zy vx vy cx cy rx ry :
  p > 0 -> K > 0 -> G > 0 -> q > 0 -> o > 0 -> J > 0 -> o * J = K * G * q ->
  Rabs (X - QX * o) <= op * o -> Rabs (Y - QY * o) <= op * o -> Rabs (C - QC * q) <= ot * q -> Rabs (S - QS * q) <= ot * q ->
  (Rabs nx + Rabs ny) * op <= (sp + 1) * J -> (Rabs nx + Rabs ny) * ot <= (st + 1) * K ->
  Rabs (nx * QC + ny * QS - SX * K) <= cl * K -> Rabs (ny * QC - nx * QS - SY * K) <= cl * K ->
  Rabs (nx * QX + ny * QY - (SB + SV) * J) <= cl * J -> Rabs (lev - SV * (p * K * G * q)) <= cv * (p * K * G * q) -> cv <= cl ->
  Rabs SX <= zx -> Rabs SY <= zy -> Rabs (vx - cx * G) <= G -> Rabs (vy - cy * G) <= G -> Rabs cx <= rx -> Rabs cy <= ry ->
  Rabs (nx * p * (X + (vx * C - vy * S)) + ny * p * (Y + (vx * S + vy * C)) - lev - (SB + (cx * SX + cy * SY)) * (p * K * G * q)) <=
  (sp + 1 + 2 * cl + (rx + ry) * (st + 1 + cl) + (zx + (st + 1 + cl)) + (zy + (st + 1 + cl))) * (p * K * G * q).
Proof.
  intros Pp PK PG Pq Po PJ OJ AX AY AC AS UB UA TX TY TB TL CV ZX ZY VX VY RX RY.
  assert (KQ : 0 < K * q) by (apply Rmult_lt_0_compat; lra).
  assert (scale : forall a b c d s, s > 0 -> Rabs (a - b * c) <= d * c -> Rabs (a * s - b * (c * s)) <= d * (c * s)).
  { intros a b c d s Hs H. replace (a * s - b * (c * s)) with ((a - b * c) * s) by ring. rewrite Rabs_mult, (Rabs_right s) by lra.
    rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra. }
  assert (FA : 0 <= st + 1 + cl).
  { assert (0 <= (st + 1 + cl) * K); [|nra]. pose proof (Rabs_pos (nx * QC + ny * QS - SX * K)).
    assert (0 <= ot * q) by (eapply Rle_trans; [apply Rabs_pos|exact AC]).
    assert (0 <= ot) by nra. pose proof (Rabs_pos nx). pose proof (Rabs_pos ny).
    assert (0 <= (Rabs nx + Rabs ny) * ot) by (apply Rmult_le_pos; lra). lra. }
  assert (A : Rabs (nx * C + ny * S - SX * (K * q)) <= (st + 1 + cl) * (K * q)).
  { pose proof (two_products nx ny C S QC QS q ot AC AS) as T. apply (scale _ _ _ _ q Pq) in TX.
    assert ((Rabs nx + Rabs ny) * ot * q <= (st + 1) * K * q) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le. apply Rabs_within in T, TX. lra. }
  assert (B : Rabs (ny * C - nx * S - SY * (K * q)) <= (st + 1 + cl) * (K * q)).
  { pose proof (two_products ny (- nx) C S QC QS q ot AC AS) as T. rewrite Rabs_Ropp in T. apply (scale _ _ _ _ q Pq) in TY.
    assert ((Rabs ny + Rabs nx) * ot * q <= (st + 1) * K * q) by (apply Rmult_le_compat_r; lra).
    apply Rabs_le. apply Rabs_within in T, TY. lra. }
  assert (D : Rabs (nx * X + ny * Y - (SB + SV) * (G * (K * q))) <= (sp + 1 + cl) * (G * (K * q))).
  { pose proof (two_products nx ny X Y QX QY o op AX AY) as T. apply (scale _ _ _ _ o Po) in TB.
    assert (E : J * o = G * (K * q)) by (rewrite (Rmult_comm J), OJ; ring). rewrite E in TB.
    assert ((Rabs nx + Rabs ny) * op * o <= (sp + 1) * (G * (K * q))).
    { rewrite <- E, <- Rmult_assoc. apply Rmult_le_compat_r; lra. }
    apply Rabs_le. apply Rabs_within in T, TB. lra. }
  pose proof (vertex_product vx cx G _ SX (K * q) _ zx rx PG KQ VX A ZX RX FA) as MX.
  pose proof (vertex_product vy cy G _ SY (K * q) _ zy ry PG KQ VY B ZY RY FA) as MY.
  replace (p * K * G * q) with (p * (G * (K * q))) in * by ring. set (T := G * (K * q)) in *.
  assert (PT : T > 0) by (apply Rmult_lt_0_compat; auto). clearbody T.
  set (d := nx * X + ny * Y) in *. set (a := nx * C + ny * S) in *. set (b := ny * C - nx * S) in *.
  replace (nx * p * (X + (vx * C - vy * S)) + ny * p * (Y + (vx * S + vy * C)))
    with (p * (d + (vx * a + vy * b))) by (unfold d, a, b; ring).
  clearbody d a b. set (E1 := d - (SB + SV) * T) in *. set (E2 := vx * a - cx * SX * T) in *. set (E3 := vy * b - cy * SY * T) in *.
  set (E4 := lev - SV * (p * T)) in *.
  replace (p * (d + (vx * a + vy * b)) - lev - (SB + (cx * SX + cy * SY)) * (p * T)) with (p * (E1 + E2 + E3) - E4)
    by (unfold E1, E2, E3, E4; ring).
  assert (cv * (p * T) <= cl * (p * T)) by (apply Rmult_le_compat_r; auto; apply Rmult_le_pos; lra).
  assert (F : Rabs (p * (E1 + E2 + E3)) <= p * ((sp + 1 + cl) * T + (rx * (st + 1 + cl) + (zx + (st + 1 + cl))) * T + (ry * (st + 1 + cl) + (zy + (st + 1 + cl))) * T)).
  { rewrite Rabs_mult, (Rabs_right p) by lra. apply Rmult_le_compat_l; [lra|]. apply Rabs_within in D, MX, MY. apply Rabs_le. lra. }
  apply Rabs_within in F, TL. apply Rabs_le. lra.
Qed.

Section Line.
  Variables (g : Z) (r s : number) (n : number * number) (level : poly) (b : box) (P : placement).
  Variables X Y C S : R -> R.
  Hypothesis NX : near r X (ox P).
  Hypothesis NY : near r Y (oy P).
  Hypothesis NC : near r C (co P).
  Hypothesis NS : near r S (si P).

  (** Of a vertex, in the direction, from the level on. *)
  Definition from_level (h vx vy : R) : R :=
    value (fst n) * (X h + (vx * C h - vy * S h)) + value (snd n) * (Y h + (vx * S h + vy * C h)) - eval level h.

  Let W := whole_of g s P.
  Let L := whole_line_of g s n level W b.

  Lemma whole_of_correct h u : Rabs h <= value r -> same_instant (value s) h u ->
    let l := coefficients W in let p := powerRZ 2 (g - place_bits) in let q := powerRZ 2 (- turn_bits) in
    Rabs (X h - series (fun t => fst (fst t)) l u * p) <= IZR (off_place W) * p /\
    Rabs (Y h - series (fun t => snd (fst t)) l u * p) <= IZR (off_place W) * p /\
    Rabs (C h - series (fun t => fst (snd t)) l u * q) <= IZR (off_turn W) * q /\
    Rabs (S h - series (fun t => snd (snd t)) l u * q) <= IZR (off_turn W) * q.
  Proof.
    intros H I. subst W. unfold whole_of.
    pose proof (whole_model_correct (g - place_bits) small_place r s X (ox P) NX h u H I) as AX.
    pose proof (whole_model_correct (g - place_bits) small_place r s Y (oy P) NY h u H I) as AY.
    pose proof (whole_model_correct (- turn_bits) small_turn r s C (co P) NC h u H I) as AC.
    pose proof (whole_model_correct (- turn_bits) small_turn r s S (si P) NS h u H I) as AS.
    destruct (whole_model (g - place_bits) small_place s (ox P)) as [x ex].
    destruct (whole_model (g - place_bits) small_place s (oy P)) as [y ey].
    destruct (whole_model (- turn_bits) small_turn s (co P)) as [c ec].
    destruct (whole_model (- turn_bits) small_turn s (si P)) as [d ed].
    cbn [coefficients off_place off_turn fst snd] in *. cbv zeta.
    set (p := powerRZ 2 (g - place_bits)) in *. set (q := powerRZ 2 (- turn_bits)) in *.
    assert (p > 0) by apply two_pos. assert (q > 0) by apply two_pos.
    rewrite (zipped_first (fun t => fst t) (0, 0)%Z (0, 0)%Z) by auto. rewrite (zipped_first (fun t => snd t) (0, 0)%Z (0, 0)%Z) by auto.
    rewrite (zipped_second (fun t => fst t) (0, 0)%Z (0, 0)%Z) by auto. rewrite (zipped_second (fun t => snd t) (0, 0)%Z (0, 0)%Z) by auto.
    rewrite !(zipped_first self 0%Z 0%Z), !(zipped_second self 0%Z 0%Z) by auto.
    assert (M : forall a e e' z, z > 0 -> (e <= e')%Z -> a <= IZR e * z -> a <= IZR e' * z).
    { intros a e e' z Hz E A. apply IZR_le in E. assert (IZR e * z <= IZR e' * z) by (apply Rmult_le_compat_r; lra). lra. }
    repeat split; (eapply M; [| |eassumption]); auto; lia.
  Qed.

  Lemma whole_line_correct h u v c : Rabs h <= value r -> same_instant (value s) h u -> close g v c -> in_box c b ->
    let e := Z.min (exponent (fst n)) (exponent (snd n)) in
    exists T, 0 < T /\
    Rabs (from_level h (value (fst v)) (value (snd v)) - along_terms (IZR (fst c)) (IZR (snd c)) (terms L) u * T) <= IZR (room L) * T /\
    Rabs (series (fun t => fst (snd t)) (terms L) u) <= IZR (room_x L) /\ Rabs (series (fun t => snd (snd t)) (terms L) u) <= IZR (room_y L).
  Proof.
    intros H I [CX CY] [BX BY] e. pose proof I as [U E]. destruct (whole_of_correct h u H I) as (AX & AY & AC & AS).
    subst L. unfold whole_line_of, from_level, along_terms. fold e. cbv zeta. cbn [terms room room_x room_y].
    pose proof (whole_exact e (fst n) ltac:(unfold e; lia)) as N1. pose proof (whole_exact e (snd n) ltac:(unfold e; lia)) as N2.
    set (nx := whole e (fst n)) in *. set (ny := whole e (snd n)) in *. rewrite N1, N2. clear N1 N2.
    set (size := (Z.abs nx + Z.abs ny)%Z). set (k := Z.log2 size). set (j := (k - (turn_bits - place_bits))%Z).
    set (lev := scaled (e + k + g - turn_bits) one s level).
    set (l := line_terms j k nx ny (coefficients W) lev).
    set (fa := (Z.shiftr (size * off_turn W) k + 1 + count l)%Z).
    set (fb := (Z.shiftr (size * off_place W) j + 1 + 2 * count l)%Z).
    pose proof (scaled_correct (e + k + g - turn_bits) s level u U one) as SV. rewrite value_one, Rmult_1_l, <- E in SV. fold lev in SV.
    destruct (line_terms_along j k nx ny (coefficients W) u U lev) as [TX TY]. fold l in TX, TY.
    pose proof (line_terms_base j k nx ny (coefficients W) u U lev) as TB. cbv zeta in TB. fold l in TB.
    pose proof (count_line_terms j k nx ny (coefficients W) lev) as CL. fold l in CL. apply IZR_le in CL.
    pose proof (series_size (fun t => fst (snd t)) l u U) as ZX. fold (size_x l) in ZX.
    pose proof (series_size (fun t => snd (snd t)) l u U) as ZY. fold (size_y l) in ZY.
    pose proof (shiftr_above (size * off_turn W) k) as UA. pose proof (shiftr_above (size * off_place W) j) as UB.
    rewrite mult_IZR in UA, UB.
    set (p := powerRZ 2 e). set (K := powerRZ 2 k) in *. set (G := powerRZ 2 g) in *. set (q := powerRZ 2 (- turn_bits)) in *.
    set (o := powerRZ 2 (g - place_bits)) in *. set (J := powerRZ 2 j) in *.
    assert (p > 0) by apply two_pos. assert (K > 0) by apply two_pos. assert (G > 0) by apply two_pos.
    assert (q > 0) by apply two_pos. assert (o > 0) by apply two_pos. assert (J > 0) by apply two_pos.
    assert (OJ : o * J = K * G * q) by (unfold o, J, K, G, q, j; rewrite <- !two_add; f_equal; lia).
    assert (ET : powerRZ 2 (e + k + g - turn_bits) = p * K * G * q) by (unfold p, K, G, q; rewrite <- !two_add; f_equal; lia).
    rewrite ET in SV.
    exists (p * K * G * q). split; [repeat apply Rmult_lt_0_compat; lra|].
    assert (SZ : IZR size = Rabs (IZR nx) + Rabs (IZR ny)) by (unfold size; rewrite plus_IZR, !abs_IZR; reflexivity).
    assert (FA : 0 <= IZR fa).
    { assert (0 <= IZR (off_turn W)) by (apply (Rmult_le_reg_r q); [lra|]; rewrite Rmult_0_l; eapply Rle_trans; [|exact AC]; apply Rabs_pos).
      assert (0 <= IZR size * IZR (off_turn W)).
      { apply Rmult_le_pos; auto. rewrite SZ. pose proof (Rabs_pos (IZR nx)). pose proof (Rabs_pos (IZR ny)). lra. }
      assert (0 <= IZR (Z.shiftr (size * off_turn W) k) + 1) by (apply (Rmult_le_reg_r K); lra).
      pose proof (count_nonneg l) as Q. apply IZR_le in Q. unfold fa. rewrite !plus_IZR. lra. }
    rewrite (plus_IZR (size_x l)), (plus_IZR (size_y l)). 
    assert (more : forall x y f : R, x <= y -> 0 <= f -> x <= y + f) by (intros; lra).
    split; [|split; [exact (more _ _ _ ZX FA)|exact (more _ _ _ ZY FA)]]. clear more.
    assert (RX : Rabs (IZR (fst c)) <= IZR (reach (fst b))).
    { rewrite <- abs_IZR. apply IZR_le. unfold in_span, reach in *. lia. }
    assert (RY : Rabs (IZR (snd c)) <= IZR (reach (snd b))).
    { rewrite <- abs_IZR. apply IZR_le. unfold in_span, reach in *. lia. }
    rewrite SZ in UA, UB. clear BX BY.
    pose proof (line_bound p K G q o J (X h) (Y h) (C h) (S h) _ _ _ _ _ _ (IZR nx) (IZR ny) _ _ (IZR (count l)) (IZR (count lev))
      (series fst l u) (series self lev u) _ _ (eval level h) _ _ (value (fst v)) (value (snd v)) (IZR (fst c)) (IZR (snd c)) _ _
      ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) OJ AX AY AC AS UB UA TX TY TB SV CL ZX ZY CX CY RX RY) as M.
    unfold fb. rewrite !plus_IZR, !mult_IZR, plus_IZR. unfold fa. rewrite !plus_IZR. exact M.
  Qed.

  Lemma cell_beyond_correct v : in_box (cell_of g v) b -> cell_beyond L (cell_of g v) = true ->
    forall h u, Rabs h <= value r -> same_instant (value s) h u -> 0 < from_level h (value (fst v)) (value (snd v)).
  Proof.
    unfold cell_beyond. intros B T h u H I. apply Z.ltb_lt, IZR_lt in T.
    destruct (whole_line_correct h u v _ H I (cell_of_close g v) B) as (t & P0 & D & _ & _).
    pose proof (lowest_correct (fst (cell_of g v)) (snd (cell_of g v)) (terms L) u (proj1 I)) as M.
    apply Rabs_within in D. nra.
  Qed.

  Lemma box_beyond_correct v a : in_box (cell_of g v) b -> in_box (cell_of g v) a -> box_beyond L a = true ->
    forall h u, Rabs h <= value r -> same_instant (value s) h u -> 0 < from_level h (value (fst v)) (value (snd v)).
  Proof.
    unfold box_beyond. intros B A T h u H I. apply Z.ltb_lt, IZR_lt in T. rewrite !plus_IZR, !mult_IZR in T.
    destruct (whole_line_correct h u v _ H I (cell_of_close g v) B) as (t & P0 & D & SX & SY).
    pose proof (lowest_correct (fst (fst a)) (fst (snd a)) (terms L) u (proj1 I)) as M.
    set (c := cell_of g v) in *. destruct A as [AX AY]. unfold in_span in AX, AY. apply IZR_le in AX, AY.
    rewrite abs_IZR, minus_IZR in AX, AY. unfold along_terms in *.
    set (B0 := series fst (terms L) u) in *. set (X0 := series (fun t => fst (snd t)) (terms L) u) in *.
    set (Y0 := series (fun t => snd (snd t)) (terms L) u) in *.
    assert (EX : Rabs ((IZR (fst c) - IZR (fst (fst a))) * X0) <= IZR (snd (fst a)) * IZR (room_x L))
      by (rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
    assert (EY : Rabs ((IZR (snd c) - IZR (fst (snd a))) * Y0) <= IZR (snd (snd a)) * IZR (room_y L))
      by (rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
    apply Rabs_within in D, EX, EY.
    assert (0 < (B0 + (IZR (fst c) * X0 + IZR (snd c) * Y0) - IZR (room L)) * t) by (apply Rmult_lt_0_compat; lra). lra.
  Qed.

  Lemma tree_beyond_correct t : right_tree g t -> (forall e, in_tree e t -> ends_in g e b) -> tree_beyond L t = true ->
    forall h u, Rabs h <= value r -> same_instant (value s) h u -> forall e, in_tree e t ->
    0 < from_level h (value (fst (fst e))) (value (snd (fst e))) /\ 0 < from_level h (value (fst (snd e))) (value (snd (snd e))).
  Proof.
    induction t as [|e a c d|a t1 IH1 t2 IH2]; intros R B T h u H I e' E; [destruct E| |].
    - cbn [in_tree] in E. subst e'. destruct R as (_ & -> & ->). cbn [tree_beyond] in T. apply andb_prop in T. destruct T.
      destruct (B e eq_refl). split; eapply cell_beyond_correct; eauto.
    - destruct R as (R & R1 & R2). cbn [tree_beyond] in T. apply orb_prop in T. destruct T as [T|T].
      + destruct (R e' E), (B e' E). split; eapply (box_beyond_correct _ a); eauto.
      + apply andb_prop in T. destruct T as [T1 T2]. destruct E as [E|E].
        * exact (IH1 R1 (fun e i => B e (or_introl i)) T1 h u H I e' E).
        * exact (IH2 R2 (fun e i => B e (or_intror i)) T2 h u H I e' E).
  Qed.
End Line.
