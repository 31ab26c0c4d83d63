(** What the checker accepts is free. *)

From Coq Require Import Reals ZArith List Bool PeanoNat Lra Lia Psatz.
From Taut Require Import Definitions Geometry Disjoint Numbers Models Functions Placement Check.
Import ListNotations.
Open Scope R_scope.

Lemma positive_correct r f M h : 0 <= value r -> near r f M -> positive r M = true -> Rabs h <= value r -> 0 < f h.
Proof.
  unfold positive. intros R N P H. apply below_correct in P. pose proof (lower_correct r (poly_of M) h R H). specialize (N h H).
  pose proof (Rle_abs (eval (poly_of M) h - f h)) as A. rewrite Rabs_minus_sym in A. lra.
Qed.

(** * Separations *)

Section Window.
  Variable r : number.
  Hypothesis R0 : 0 <= value r.
  Variables F G : R -> frame.
  Variables P Q : placement.
  Hypothesis NF : near_frame r F P.
  Hypothesis NG : near_frame r G Q.

  Definition place (H : R -> frame) (h : R) (v : vertex) : point := apply (H h) (values v).

  Definition near_projection (B X Y : R -> R) (J : projection) : Prop :=
    near r B (base J) /\ near r X (per_x J) /\ near r Y (per_y J).
  Definition vertex_along (B X Y : R -> R) (v : vertex) (h : R) : R := B h + (value (fst v) * X h + value (snd v) * Y h).

  Lemma near_along B X Y J v : near_projection B X Y J -> near r (vertex_along B X Y v) (along_direction J v).
  Proof.
    intros (NB & NX & NY). unfold vertex_along, along_direction.
    apply (near_madd r B (fun h => _)); auto. apply (near_madd r (fun h => _) (fun h => _)); apply near_mscale; auto.
  Qed.

  Lemma near_rough_along B X Y J v w g : near_projection B X Y J ->
    Rabs (value (fst v) - value (fst w)) <= value (Number 1 g) -> Rabs (value (snd v) - value (snd w)) <= value (Number 1 g) ->
    near r (vertex_along B X Y v) (rough_along (rough_projection g r J) w).
  Proof.
    intros (NB & NX & NY) Hx Hy h Hh. unfold rough_along, rough_projection. cbn [base per_x per_y poly_of slack].
    apply (near_shorter r rough_bits rough_negligible) in NB, NX, NY. fold (rough r (base J)) in NB.
    fold (rough r (per_x J)) in NX. fold (rough r (per_y J)) in NY.
    pose proof (bound_correct r X _ h NX Hh) as BX. pose proof (bound_correct r Y _ h NY Hh) as BY.
    specialize (NB h Hh). specialize (NX h Hh). specialize (NY h Hh).
    set (b := rough r (base J)) in *. set (x := rough r (per_x J)) in *. set (y := rough r (per_y J)) in *.
    rewrite !eval_padd, !eval_pscale, !value_add, !value_mul, !value_size.
    pose proof (round_up_correct (add (slack b) (mul (Number 1 g) (add (bound r x) (bound r y))))) as U.
    rewrite value_add, value_mul, value_add in U.
    set (grid_ := value (Number 1 g)) in *. set (S := value (round_up _)) in *.
    unfold vertex_along.
    replace (B h + (value (fst v) * X h + value (snd v) * Y h) -
             (eval (poly_of b) h + (value (fst w) * eval (poly_of x) h + value (snd w) * eval (poly_of y) h)))
      with (B h - eval (poly_of b) h +
            ((value (fst v) - value (fst w)) * X h + value (fst w) * (X h - eval (poly_of x) h) +
             ((value (snd v) - value (snd w)) * Y h + value (snd w) * (Y h - eval (poly_of y) h)))) by ring.
    assert (TX : Rabs ((value (fst v) - value (fst w)) * X h + value (fst w) * (X h - eval (poly_of x) h)) <=
                 grid_ * value (bound r x) + Rabs (value (fst w)) * value (slack x)).
    { eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
      apply Rplus_le_compat; apply Rmult_le_compat; auto using Rabs_pos; lra. }
    assert (TY : Rabs ((value (snd v) - value (snd w)) * Y h + value (snd w) * (Y h - eval (poly_of y) h)) <=
                 grid_ * value (bound r y) + Rabs (value (snd w)) * value (slack y)).
    { eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
      apply Rplus_le_compat; apply Rmult_le_compat; auto using Rabs_pos; lra. }
    eapply Rle_trans; [apply Rabs_triang|].
    eapply Rle_trans; [apply Rplus_le_compat_l, Rabs_triang|]. lra.
  Qed.

  Lemma beyond_correct B X Y J g v : near_projection B X Y J -> beyond g r J (corner_of g v) = true ->
    forall h, Rabs h <= value r -> 0 < vertex_along B X Y v h.
  Proof.
    intros N H h Hh. unfold beyond in H. apply orb_prop in H. destruct H as [H|H].
    - eapply positive_correct in H; eauto. apply near_rough_along; auto; apply on_grid_correct.
    - eapply positive_correct in H; eauto. apply near_along; auto.
  Qed.

  Definition rest (H : R -> frame) (n : number * number) (level : poly) (h : R) : R :=
    value (fst n) * fst (at_ (H h)) + value (snd n) * snd (at_ (H h)) - eval level h.
  Definition along_x (H : R -> frame) (n : number * number) (h : R) : R :=
    value (fst n) * fst (along (H h)) + value (snd n) * snd (along (H h)).
  Definition along_y (H : R -> frame) (n : number * number) (h : R) : R :=
    value (snd n) * fst (along (H h)) - value (fst n) * snd (along (H h)).

  Lemma near_project n level H J : near_frame r H J ->
    near_projection (rest H n level) (along_x H n) (along_y H n) (project r n level J).
  Proof.
    intros (X & Y & C & S). unfold near_projection, project; cbn [base per_x per_y]. repeat split.
    - apply (near_msub r (fun h => _) (eval level)); [|apply near_eval].
      apply (near_madd r (fun h => _) (fun h => _)); apply near_mscale; auto.
    - apply (near_madd r (fun h => _) (fun h => _)); apply near_mscale; auto.
    - apply (near_msub r (fun h => _) (fun h => _)); apply near_mscale; auto.
  Qed.
  Lemma near_opposite B X Y J : near_projection B X Y J ->
    near_projection (fun h => - B h) (fun h => - X h) (fun h => - Y h) (opposite J).
  Proof. intros (NB & NX & NY). repeat split; apply near_mneg; auto. Qed.

  Lemma vertex_along_place n level H v h :
    vertex_along (rest H n level) (along_x H n) (along_y H n) v h = dot (values n) (place H h v) - eval level h.
  Proof. unfold vertex_along, rest, along_x, along_y, dot, place, apply, plus, turned, values; simpl. ring. Qed.
  Lemma vertex_along_opposite B X Y v h :
    vertex_along (fun h => - B h) (fun h => - X h) (fun h => - Y h) v h = - vertex_along B X Y v h.
  Proof. unfold vertex_along. ring. Qed.

  Definition edge_place (H : R -> frame) (h : R) (e : vertex * vertex) : point * point := (place H h (fst e), place H h (snd e)).

  Lemma same_vertex_correct u v : same_vertex u v = true -> u = v.
  Proof.
    destruct u as [[m e] [m' e']], v as [[n f] [n' f']]. unfold same_vertex, same_number; simpl.
    rewrite !andb_true_iff, !Z.eqb_eq. intros [[-> ->] [-> ->]]. reflexivity.
  Qed.
  Lemma same_corner_correct c d : same_corner c d = true -> c = d.
  Proof.
    destruct c as [u u'], d as [v v']. unfold same_corner; simpl. rewrite andb_true_iff.
    intros [A B]. apply same_vertex_correct in A, B. subst. reflexivity.
  Qed.
  Lemma ends_correct test l e : ends test l = true -> In e l -> test (fst e) = true /\ test (snd e) = true.
  Proof.
    induction l as [|e' l IH]; [intros _ []|]. cbn [ends]. rewrite !andb_true_iff. intros [[A B] C] [<-|I]; [|auto].
    split; auto. destruct l as [|f l]; auto. apply orb_prop in C. destruct C as [C|C]; auto.
    apply same_corner_correct in C. rewrite C. cbn [ends] in B. rewrite !andb_true_iff in B. tauto.
  Qed.

  Definition has_edge (E : outline) (e : vertex * vertex) : Prop := In (edge_corners (grid E) e) (corners E).

  Lemma line_correct n level E E' : separated r P Q E E' (Line n level) = true -> forall h, Rabs h <= value r ->
    (forall e, has_edge E e -> dot (values n) (place F h (fst e)) < eval level h /\ dot (values n) (place F h (snd e)) < eval level h) /\
    (forall e, has_edge E' e -> eval level h < dot (values n) (place G h (fst e)) /\ eval level h < dot (values n) (place G h (snd e))).
  Proof.
    cbn [separated]. intros H h Hh. apply andb_prop in H. destruct H as [H1 H2].
    pose proof (near_opposite _ _ _ _ (near_project n level F P NF)) as NP. pose proof (near_project n level G Q NG) as NQ.
    split; intros e I.
    - destruct (ends_correct _ _ _ H1 I) as [A B].
      pose proof (beyond_correct _ _ _ _ _ _ NP A h Hh) as A'. pose proof (beyond_correct _ _ _ _ _ _ NP B h Hh) as B'.
      rewrite vertex_along_opposite, vertex_along_place in A', B'. lra.
    - destruct (ends_correct _ _ _ H2 I) as [A B].
      pose proof (beyond_correct _ _ _ _ _ _ NQ A h Hh) as A'. pose proof (beyond_correct _ _ _ _ _ _ NQ B h Hh) as B'.
      rewrite vertex_along_place in A', B'. lra.
  Qed.

  (** One direction for two edges, throughout the window. *)
  Definition kept_apart (e f : vertex * vertex) : Prop := exists n, forall h, Rabs h <= value r ->
    dot n (place F h (fst e)) < dot n (place G h (fst f)) /\ dot n (place F h (fst e)) < dot n (place G h (snd f)) /\
    dot n (place F h (snd e)) < dot n (place G h (fst f)) /\ dot n (place F h (snd e)) < dot n (place G h (snd f)).

  Lemma in_halves {A} (l : list A) x : In x l -> In x (fst (halves l)) \/ In x (snd (halves l)).
  Proof. unfold halves; simpl. intros I. apply in_app_or. rewrite firstn_skipn. auto. Qed.

  Lemma separated_correct s : forall E E', separated r P Q E E' s = true ->
    forall e f, has_edge E e -> has_edge E' f -> kept_apart e f.
  Proof.
    induction s as [n level|s1 IH1 s2 IH2|s1 IH1 s2 IH2]; intros E E' H e f He Hf.
    - exists (values n). intros h Hh. destruct (line_correct n level E E' H h Hh) as [A B].
      specialize (A e He). specialize (B f Hf). lra.
    - cbn [separated] in H. unfold has_edge in He. destruct (in_halves _ _ He) as [I|I];
        destruct (halves (corners E)) as [E1 E2]; apply andb_prop in H; destruct H as [H1 H2].
      + apply (IH1 _ _ H1); auto.
      + apply (IH2 _ _ H2); auto.
    - cbn [separated] in H. unfold has_edge in Hf. destruct (in_halves _ _ Hf) as [I|I];
        destruct (halves (corners E')) as [E1 E2]; apply andb_prop in H; destruct H as [H1 H2].
      + apply (IH1 _ _ H1); auto.
      + apply (IH2 _ _ H2); auto.
  Qed.
End Window.

(** * Parity in the middle *)

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

(** * Windows *)

Lemma in_edges_of b p e : In p (shape b) -> In e (all_edges_of p) -> In e (edges_of b).
Proof. intros. unfold edges_of. apply in_flat_map. eauto. Qed.

Lemma kept_apart_parts r F G h p q : Rabs h <= value r ->
  (forall e f, In e (all_edges_of p) -> In f (all_edges_of q) -> kept_apart r F G e f) ->
  apart (placed_part F h p) (placed_part G h q).
Proof.
  intros H K e f. rewrite !all_edges_placed, !in_map_iff. intros (e' & <- & He) (f' & <- & Hf).
  destruct (K e' f' He Hf) as (n & N). destruct (N h H) as (A & B & C & D). exists n. repeat split; auto.
Qed.

Lemma kept_apart_sym r F G e f : kept_apart r F G e f -> kept_apart r G F f e.
Proof.
  intros (n & N). exists (- fst n, - snd n). intros h H. destruct (N h H) as (A & B & C & D).
  unfold dot in *; cbn [fst snd]; repeat split; lra.
Qed.

(** What is outside in the middle is outside throughout the window. *)
Lemma outside_kept r F G h p q : 0 <= value r -> Rabs h <= value r ->
  (forall e f, In e (all_edges_of p) -> In f (all_edges_of q) -> kept_apart r F G e f) ->
  (forall rg, In rg p -> edges rg <> [] -> exists e k, In e (edges rg) /\ 0 <= k <= 1 /\
     odd (between k (place F 0 (fst e)) (place F 0 (snd e))) (placed_part G 0 q) = false) ->
  rings_outside (placed_part F h p) (placed_part G h q).
Proof.
  intros R H K O rg' Hr Ne. unfold placed_part in Hr. apply in_map_iff in Hr. destruct Hr as (rg & <- & Hr).
  rewrite edges_map in Ne |- *. destruct (O rg Hr) as (e & k & He & Hk & Od).
  { intros E. rewrite E in Ne. auto. }
  exists (place F h (fst e), place F h (snd e)), (between k (place F h (fst e)) (place F h (snd e))). split.
  { apply (in_map (fun e => (place F h (fst e), place F h (snd e)))). auto. }
  split; [exists k; auto|]. rewrite <- Od. symmetry. apply odd_step. intros rg2 f Hr2 Hf.
  destruct (K e f) as (n & N); try (unfold all_edges_of; apply in_flat_map; eauto).
  exists n. assert (Z : Rabs 0 <= value r) by (rewrite Rabs_R0; auto).
  destruct (N 0 Z) as (A & B & C & D). destruct (N h H) as (A' & B' & C' & D').
  assert (OE : forall h, on_edge (between k (place F h (fst e)) (place F h (snd e))) (place F h (fst e)) (place F h (snd e)))
    by (intros; exists k; auto).
  repeat split; eapply on_edge_before; eauto.
Qed.

Lemma placed_part_turned F h p : placed_part F h p = map (map (apply (F h))) (map (map values) p).
Proof. unfold placed_part. rewrite map_map. apply map_ext. intros rg. rewrite map_map. reflexivity. Qed.

Definition covered (c : list motion) (b : body) (after : bool) (t : R) (z : point) : Prop :=
  exists p q, In p (shape b) /\ in_part q (map (map values) p) /\ z = placed after c t q.

Lemma has_edge_of b p e : In p (shape b) -> In e (all_edges_of p) -> has_edge (outline_of b) e.
Proof. intros Hp He. unfold has_edge, outline_of. cbn [grid corners]. apply in_map. eapply in_edges_of; eauto. Qed.

(** Two parts that a separation with halves keeps apart. *)
Lemma parts_apart r F G h s t P0 Q0 p q : 0 <= value r -> Rabs h <= value r ->
  near_frame zero F P0 -> near_frame zero G Q0 -> outside P0 Q0 s t = true -> outside Q0 P0 t s = true ->
  (forall e f, In e (all_edges_of p) -> In f (all_edges_of q) -> kept_apart r F G e f) -> In p s -> In q t ->
  forall z, ~ (in_part z (placed_part F h p) /\ in_part z (placed_part G h q)).
Proof.
  intros R H MF MG O1 O2 K Hp Hq. apply parts_disjoint.
  - apply (kept_apart_parts r); auto.
  - apply (outside_kept r); auto. intros. eapply (outside_correct F G P0 Q0 s t); eauto.
  - apply (outside_kept r); auto.
    + intros e f He Hf. apply kept_apart_sym. auto.
    + intros. eapply (outside_correct G F Q0 P0 t s); eauto.
Qed.

Lemma check_window_correct ca cb a b w closed :
  check_window ca cb a b (outline_of a) (outline_of b) w = Some closed ->
  forall t after, in_window (opens w) (closes w) closed after t -> forall z, ~ (covered ca a after t z /\ covered cb b after t z).
Proof.
  unfold check_window. set (mid := half (add (opens w) (closes w))). set (r := half (sub (closes w) (opens w))).
  destruct (at_most zero r) eqn:R0; [|discriminate]. apply at_most_correct in R0. rewrite value_zero in R0.
  destruct (chain_model _ _ mid r ca) as [[P c1]|] eqn:CA; [|discriminate].
  destruct (chain_model _ _ mid r cb) as [[Q c2]|] eqn:CB; [|discriminate].
  destruct (separated r P Q (outline_of a) (outline_of b) (how w)) eqn:S; [|discriminate].
  destruct (is_line (how w) || outside_in_the_middle ca cb a b w mid) eqn:O; [|discriminate]. intros [= <-].
  destruct (chain_correct _ _ _ _ _ _ _ R0 CA) as (NF & PF & AF).
  destruct (chain_correct _ _ _ _ _ _ _ R0 CB) as (NG & PG & AG).
  set (F := fun h => chain_frame (opens w) (closes w) ca (value mid + h)) in *.
  set (G := fun h => chain_frame (opens w) (closes w) cb (value mid + h)) in *.
  intros t after W z [(p & x & Hp & Ix & Ex) (q & y & Hq & Iy & Ey)].
  set (h := t - value mid). assert (T : t = value mid + h) by (unfold h; ring).
  assert (H : Rabs h <= value r).
  { destruct W as [W _]. unfold h, mid, r in *. rewrite value_half, value_sub in R0. rewrite !value_half, value_sub, value_add.
    apply Rabs_le. lra. }
  clearbody h. subst t.
  rewrite (AF h after x) in Ex by (apply (in_window_weaken _ _ (c1 && c2)); auto; destruct c1; auto).
  rewrite (AG h after y) in Ey by (apply (in_window_weaken _ _ (c1 && c2)); auto; destruct c1, c2; auto).
  change (z = apply (F h) x) in Ex. change (z = apply (G h) y) in Ey.
  assert (Jp : in_part z (placed_part F h p)) by (rewrite Ex, placed_part_turned; apply in_part_turned; auto; apply PF; auto).
  assert (Jq : in_part z (placed_part G h q)) by (rewrite Ey, placed_part_turned; apply in_part_turned; auto; apply PG; auto).
  destruct (is_line (how w)) eqn:HW.
  - destruct (how w) as [n level| |] eqn:HL; try discriminate.
    destruct (line_correct r R0 F G P Q NF NG n level _ _ S h H) as [A B].
    apply (parts_on_sides (values n) (eval level h) (placed_part F h p) (placed_part G h q)) with (z := z); auto.
    + intros e He. rewrite all_edges_placed in He. apply in_map_iff in He. destruct He as (e' & <- & He).
      apply A. eapply has_edge_of; eauto.
    + intros e He. rewrite all_edges_placed in He. apply in_map_iff in He. destruct He as (e' & <- & He).
      apply B. eapply has_edge_of; eauto.
  - cbn [orb] in O. unfold outside_in_the_middle in O.
    destruct (chain_model _ _ mid zero ca) as [[P0 c3]|] eqn:CA0; [|discriminate].
    destruct (chain_model _ _ mid zero cb) as [[Q0 c4]|] eqn:CB0; [|discriminate].
    apply andb_prop in O. destruct O as [O1 O2].
    destruct (chain_correct _ _ _ _ _ _ _ zero_nonneg CA0) as (MF & _). destruct (chain_correct _ _ _ _ _ _ _ zero_nonneg CB0) as (MG & _).
    apply (parts_apart r F G h (shape a) (shape b) P0 Q0 p q) with (z := z); auto.
    intros e f He Hf. eapply separated_correct; eauto; eapply has_edge_of; eauto.
Qed.

Lemma check_windows_correct check (safe : R -> bool -> Prop) stop l :
  (forall w closed, check w = Some closed -> forall t after, in_window (opens w) (closes w) closed after t -> safe t after) ->
  forall time, check_windows check time stop l = true ->
  forall t after, value time <= t <= value stop -> (after = false -> value time < t) -> safe t after.
Proof.
  intros C. induction l as [|w l IH]; intros time H t after T A; [discriminate|].
  cbn [check_windows] in H. apply andb_prop in H. destruct H as [H1 H2]. apply at_most_correct in H1.
  destruct (check w) as [closed|] eqn:E; [|discriminate].
  assert (D : in_window (opens w) (closes w) closed after t \/ (value (closes w) < t \/ (t = value (closes w) /\ after = true /\ closed = false))).
  { unfold in_window. destruct (Rtotal_order t (value (closes w))) as [L|[L|L]]; [left| |right; left; lra].
    - repeat split; try lra; auto. intros F. specialize (A F). lra.
    - destruct after, closed; [left|right; right; auto|left|left]; repeat split; try lra; auto; try discriminate.
      all: intros F; specialize (A F); lra. }
  destruct D as [D|D]; [eapply C; eauto|].
  apply orb_prop in H2. destruct H2 as [H2|H2].
  - exfalso. apply andb_prop in H2. destruct H2 as [M N]. apply at_most_correct in M. apply orb_prop in N.
    destruct D as [D|(D1 & D2 & D3)]; [lra|]. destruct N as [N|N]; [congruence|]. apply below_correct in N. lra.
  - apply (IH (closes w)); auto; [destruct D as [D|(D & _)]; lra|].
    intros F. destruct D as [D|(_ & D & _)]; [lra|congruence].
Qed.

(** * Pairs *)

Lemma without_common_correct c d c' d' : without_common c d = (c', d') -> forall after t p q,
  placed after c t p = placed after d t q -> placed after c' t p = placed after d' t q.
Proof.
  revert d; induction c as [|m c IH]; intros d; [intros [= <- <-]; auto|].
  destruct d as [|n d]; [intros [= <- <-]; auto|]. cbn [without_common].
  destruct (regular m) eqn:Rg; [|intros [= <- <-]; auto]. destruct (motion_eq m n) as [<-|]; [|intros [= <- <-]; auto].
  intros E after t p q H. apply (IH d E). cbn in H. apply (regular_follow after m t); auto.
Qed.

Lemma is_tested_correct s i j a b : tested s i j a b -> is_tested s i j a b = true.
Proof.
  intros (_ & _ & _ & I1 & I2 & C). unfold is_tested. apply andb_true_intro. split.
  - apply negb_true_iff. apply not_true_is_false. intros E. apply existsb_exists in E. destruct E as ([x y] & I & E).
    unfold is_pair in E. simpl in E. apply orb_prop in E.
    destruct E as [E|E]; apply andb_prop in E; destruct E as [E1 E2]; apply Nat.eqb_eq in E1, E2; subst; auto.
  - destruct C as [C|C]; [rewrite C; auto|]. destruct (chain_eq (chain a) (chain b)); [congruence|]. apply orb_true_r.
Qed.

Definition disjoint_until (s : scene) (stop : number) (a b : body) : Prop :=
  forall t after, value (start s) <= t <= value stop -> (after = false -> value (start s) < t) ->
  forall z, ~ (covers a after t z /\ covers b after t z).

Lemma check_pair_correct s stop i a j b l l' :
  check_pair s stop (i, (a, outline_of a)) (j, (b, outline_of b)) l = Some l' -> tested s i j a b -> disjoint_until s stop a b.
Proof.
  unfold check_pair. intros H T. rewrite (is_tested_correct _ _ _ _ _ T) in H. destruct l as [|[ij windows] rest]; [discriminate|].
  destruct (without_common (chain a) (chain b)) as [ca cb] eqn:E. destruct (is_pair i j ij); [|discriminate]. simpl in H.
  destruct (check_windows _ _ _ _) eqn:W; [|discriminate]. intros t after Ht A z [(p & x & Hp & Ix & Ex) (q & y & Hq & Iy & Ey)].
  pose proof (check_windows_correct _ (fun t after => forall z, ~ (covered ca a after t z /\ covered cb b after t z)) _ _
    (fun w closed C => check_window_correct ca cb a b w closed C) _ W t after Ht A) as N. cbv beta in N.
  apply (N (placed after ca t x)). split; [exists p, x; auto|]. exists q, y. split; auto. split; auto.
  apply (without_common_correct _ _ _ _ E). congruence.
Qed.

Lemma check_row_correct s stop x ys l l' : check_row s stop x ys l = Some l' ->
  forall y, In y ys -> exists m m', check_pair s stop x y m = Some m'.
Proof.
  revert l; induction ys as [|y' ys IH]; intros l H y; [intros []|]. cbn [check_row] in H.
  destruct (check_pair s stop x y' l) as [m|] eqn:E; [|discriminate]. intros [<-|I]; eauto.
Qed.

Lemma check_rows_correct s stop xs l l' : check_rows s stop xs l = Some l' ->
  forall before x after y, xs = before ++ x :: after -> In y after -> exists m m', check_pair s stop x y m = Some m'.
Proof.
  revert l; induction xs as [|x' xs IH]; intros l H before x after y E I; [destruct before; discriminate|].
  cbn [check_rows] in H. destruct (check_row s stop x' xs l) as [m|] eqn:C; [|discriminate].
  destruct before as [|b before]; injection E; intros E' ->.
  - subst. eapply check_row_correct; eauto.
  - eapply IH; eauto.
Qed.

Lemma number_bodies_nth l k i b : nth_error l i = Some b -> nth_error (number_bodies k l) i = Some ((k + i)%nat, (b, outline_of b)).
Proof.
  revert k i; induction l as [|b' l IH]; intros k i; [destruct i; discriminate|]. destruct i as [|i]; simpl.
  - intros [= ->]. rewrite Nat.add_0_r. reflexivity.
  - intros E. rewrite (IH (S k) i E). f_equal. f_equal. lia.
Qed.

Theorem accepted_is_free : forall (s : scene) (l : log), check s l = true -> free_until s (value (proved_until l)).
Proof.
  intros s l H. unfold check in H. destruct (check_rows _ _ _ _) as [rest|] eqn:C; [|discriminate]. clear H.
  intros t after Ht A i j a b T z. pose proof T as (L & Na & Nb & _).
  apply (number_bodies_nth _ 0) in Na, Nb. simpl in Na, Nb.
  destruct (nth_error_split _ _ Na) as (before & following & E & Len).
  assert (I : In (j, (b, outline_of b)) following).
  { rewrite E, nth_error_app2 in Nb by lia. destruct (j - length before)%nat eqn:D; [lia|]. simpl in Nb. eapply nth_error_In; eauto. }
  destruct (check_rows_correct _ _ _ _ _ C _ _ _ _ E I) as (m & m' & P).
  apply (check_pair_correct s (proved_until l) i a j b m m'); auto.
Qed.
