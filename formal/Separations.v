(** What the steps of a window say: each two edges keep on different sides of a line. *)

From Coq Require Import Reals ZArith List Bool PeanoNat Lra Lia Psatz.
From Taut Require Import Definitions Geometry Disjoint Numbers Models Functions Placement Check.
Import ListNotations.
Open Scope R_scope.

Lemma positive_correct r f M h : 0 <= value r -> near r f M -> positive r M = true -> Rabs h <= value r -> 0 < f h.
Proof.
  unfold positive. intros R N P H. apply below_correct in P. pose proof (lower_correct r (poly_of M) h R H). specialize (N h H).
  pose proof (Rle_abs (eval (poly_of M) h - f h)) as A. rewrite Rabs_minus_sym in A. lra.
Qed.

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
