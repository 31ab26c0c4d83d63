(** What is outside of a part in the middle of a window, by crossings that are certain. *)

From Coq Require Import Reals ZArith List Bool PeanoNat Lra Lia Psatz.
From Taut Require Import Definitions Geometry Disjoint Numbers Models Functions Placement Outlines Check Separations.
Import ListNotations.
Open Scope R_scope.

Definition near0 := near zero.
Lemma zero_nonneg : 0 <= value zero.
Proof. rewrite value_zero. lra. Qed.
Lemma zero_in : Rabs 0 <= value zero.
Proof. rewrite value_zero, Rabs_R0. lra. Qed.

Definition near_spot (p : R -> point) (S : spot) : Prop := near0 (fun h => fst (p h)) (fst S) /\ near0 (fun h => snd (p h)) (snd S).

Lemma sign_correct f M b : near0 f M -> sign M = Some b -> if b then 0 < f 0 else f 0 < 0.
Proof.
  unfold sign. intros N. destruct (positive zero M) eqn:A.
  - intros [= <-]. apply (positive_correct zero f M 0); auto using zero_nonneg, zero_in.
  - destruct (positive zero (mneg M)) eqn:B; [|discriminate]. intros [= <-].
    pose proof (positive_correct zero (fun h => - f h) (mneg M) 0 zero_nonneg (near_mneg zero f M N) B zero_in). simpl in H. lra.
Qed.

Lemma crosses_spot_correct w u v W U V c : near_spot w W -> near_spot u U -> near_spot v V ->
  crosses_spot W U V = Some c -> crosses (w 0) (u 0) (v 0) = c.
Proof.
  intros [WX WY] [UX UY] [VX VY]. unfold crosses_spot.
  pose proof (near_msub zero _ _ _ _ UX WX) as NUX. pose proof (near_msub zero _ _ _ _ UY WY) as NUY.
  pose proof (near_msub zero _ _ _ _ VX WX) as NVX. pose proof (near_msub zero _ _ _ _ VY WY) as NVY.
  destruct (sign (msub (snd U) (snd W))) as [a|] eqn:A; [|discriminate].
  destruct (sign (msub (snd V) (snd W))) as [b|] eqn:B; [|discriminate].
  pose proof (sign_correct _ _ _ NUY A) as SA. pose proof (sign_correct _ _ _ NVY B) as SB. cbv beta in SA, SB.
  unfold crosses. destruct (w 0) as [wx wy] eqn:Ew, (u 0) as [ux uy] eqn:Eu, (v 0) as [vx vy] eqn:Ev. simpl in *.
  assert (LA : less wy uy = a) by (destruct a; [apply less_true|apply less_false]; lra).
  assert (LB : less wy vy = b) by (destruct b; [apply less_true|apply less_false]; lra).
  rewrite LA, LB. destruct (Bool.eqb a b) eqn:AB.
  - intros [= <-]. destruct a, b; auto; discriminate.
  - pose proof (near_msub zero _ _ _ _ (near_mmul zero zero_nonneg _ _ _ _ NUX NVY) (near_mmul zero zero_nonneg _ _ _ _ NVX NUY)) as D.
    destruct (sign (msub (mmul zero _ _) _)) as [d|] eqn:S; [|discriminate]. intros [= <-].
    pose proof (sign_correct _ _ _ D S) as SD. cbv beta in SD. rewrite Ew, Eu, Ev in SD. simpl in SD.
    assert (X : xorb a b = true) by (destruct a, b; auto; discriminate). rewrite X. simpl.
    assert (NZ : vy - uy <> 0) by (destruct a, b; try discriminate; lra).
    set (k := (vx - ux) / (vy - uy)). assert (K : vx = ux + k * (vy - uy)) by (unfold k; field; auto).
    assert (E : (ux - wx) * (vy - wy) - (vx - wx) * (uy - wy) = (vy - uy) * (ux + (wy - uy) * k - wx)) by (rewrite K; ring).
    rewrite E in SD. clearbody k. clear E K S D.
    destruct a, b, d; try discriminate; simpl; try apply less_true; try apply less_false; nra.
Qed.

Lemma odd_spot_correct {A} w W (l : list (A * A)) (p : A -> R -> point) (S : A * A -> spot * spot) c : near_spot w W ->
  (forall e, near_spot (p (fst e)) (fst (S e)) /\ near_spot (p (snd e)) (snd (S e))) ->
  odd_spot W (map S l) = Some c -> sum (fun e => crosses (w 0) (p (fst e) 0) (p (snd e) 0)) l = c.
Proof.
  intros NW NS. revert c; induction l as [|e l IH]; intros c; [intros [= <-]; auto|]. cbn [map odd_spot].
  destruct (NS e) as [N1 N2]. destruct (crosses_spot W _ _) as [x|] eqn:X; [|discriminate].
  destruct (odd_spot W (map S l)) as [o|]; [|discriminate]. intros [= <-]. simpl.
  rewrite (IH o eq_refl). f_equal. eapply crosses_spot_correct; eauto.
Qed.

Lemma near_place_vertex F P v : near_frame zero F P -> near_spot (fun h => place F h v) (place_vertex P v).
Proof.
  intros (X & Y & C & S). unfold place_vertex, near_spot; cbn [fst snd]. split.
  - apply (near_ext zero (fun h => fst (at_ (F h)) + (value (fst v) * fst (along (F h)) - value (snd v) * snd (along (F h))))).
    { intros h. unfold place, apply, plus, turned, values; simpl. ring. }
    apply (near_madd zero (fun h => _) (fun h => _)); auto. apply (near_msub zero (fun h => _) (fun h => _)); apply near_mscale; auto.
  - apply (near_ext zero (fun h => snd (at_ (F h)) + (value (fst v) * snd (along (F h)) + value (snd v) * fst (along (F h))))).
    { intros h. unfold place, apply, plus, turned, values; simpl. ring. }
    apply (near_madd zero (fun h => _) (fun h => _)); auto. apply (near_madd zero (fun h => _) (fun h => _)); apply near_mscale; auto.
Qed.

Lemma near_spot_between k u v U V : near_spot u U -> near_spot v V ->
  near_spot (fun h => between (value k) (u h) (v h)) (spot_between k U V).
Proof.
  intros [UX UY] [VX VY]. unfold near_spot, between, spot_between; cbn [fst snd]. split.
  - apply (near_madd zero (fun h => fst (u h)) (fun h => value k * (fst (v h) - fst (u h)))); auto.
    apply near_mscale. apply (near_msub zero (fun h => fst (v h))); auto.
  - apply (near_madd zero (fun h => snd (u h)) (fun h => value k * (snd (v h) - snd (u h)))); auto.
    apply near_mscale. apply (near_msub zero (fun h => snd (v h))); auto.
Qed.

Lemma fraction_range k : In k fractions -> 0 <= value k <= 1.
Proof.
  assert (T : value (Number 1 (- (10))) = / 1024) by (apply (value_power 10); lia).
  assert (V : forall m, value (Number m (-10)) = IZR m * / 1024).
  { intros m. rewrite <- T. Transparent value. unfold value. cbn [mantissa exponent Z.opp]. ring. Opaque value. }
  intros [<-|[<-|[]]]; rewrite V; lra.
Qed.

Definition placed_part (F : R -> frame) (h : R) (p : list (list vertex)) : part := map (map (place F h)) p.

Lemma all_edges_placed F h p : all_edges (placed_part F h p) = map (edge_place F h) (all_edges_of p).
Proof.
  unfold all_edges, placed_part, all_edges_of. induction p as [|r p IH]; simpl; auto. rewrite IH, edges_map, map_app. reflexivity.
Qed.

Lemma placed_edges_spots P p : placed_edges P p = map (spots P) (all_edges_of p).
Proof. unfold placed_edges, all_edges_of. induction p as [|r p IH]; simpl; auto. rewrite edges_map, IH, map_app. reflexivity. Qed.

(** Each ring has a point of an edge that is outside of the other part in the middle. *)
Lemma outside_correct F G P Q s t : near_frame zero F P -> near_frame zero G Q -> outside P Q s t = true ->
  forall p q rg, In p s -> In q t -> In rg p -> edges rg <> [] ->
  exists e k, In e (edges rg) /\ 0 <= k <= 1 /\
    odd (between k (place F 0 (fst e)) (place F 0 (snd e))) (placed_part G 0 q) = false.
Proof.
  intros NF NG H p q rg Hp Hq Hr Ne. unfold outside in H. rewrite forallb_forall in H. specialize (H p Hp).
  rewrite forallb_forall in H. specialize (H rg Hr). destruct rg as [|v0 rg]; [destruct Ne; auto|].
  unfold ring_outside in H. rewrite forallb_forall in H.
  specialize (H (placed_edges Q q) (in_map _ _ _ Hq)). rewrite placed_edges_spots in H. apply existsb_exists in H. destruct H as (e & He & H).
  unfold spots at 1 in H. apply existsb_exists in H. destruct H as (k & Hk & H).
  exists e, (value k). split; auto. split; [apply fraction_range; auto|].
  destruct (odd_spot _ _) as [[|]|] eqn:O; try discriminate. clear H.
  pose proof (near_spot_between k _ _ _ _ (near_place_vertex F P (fst e) NF) (near_place_vertex F P (snd e) NF)) as NW.
  pose proof (odd_spot_correct _ _ _ (fun v h => place G h v) (spots Q) _ NW
    (fun e => conj (near_place_vertex G Q (fst e) NG) (near_place_vertex G Q (snd e) NG)) O) as S.
  rewrite odd_all_edges, all_edges_placed, sum_map. exact S.
Qed.
