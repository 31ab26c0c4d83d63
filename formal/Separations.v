(** What the steps of a window say: each two edges keep on different sides of a line. *)

From Coq Require Import Reals ZArith List Bool PeanoNat Lra Lia Psatz.
From Taut Require Import Definitions Geometry Disjoint Numbers Models Functions Placement Outlines Whole Lines Check.
Import ListNotations.
Open Scope R_scope.

Lemma positive_correct r f M h : 0 <= value r -> near r f M -> positive r M = true -> Rabs h <= value r -> 0 < f h.
Proof.
  unfold positive. intros R N P H. apply below_correct in P. pose proof (lower_correct r (poly_of M) h R H). specialize (N h H).
  pose proof (Rle_abs (eval (poly_of M) h - f h)) as A. rewrite Rabs_minus_sym in A. lra.
Qed.

Section Window.
  Variables r s : number.
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
  Lemma vertex_along_place n level H v h :
    vertex_along (rest H n level) (along_x H n) (along_y H n) v h = dot (values n) (place H h v) - eval level h.
  Proof. unfold vertex_along, rest, along_x, along_y, dot, place, apply, plus, turned, values; simpl. ring. Qed.

  (** Both ends of an edge. *)
  Definition edge_beyond (H : R -> frame) (n : number * number) (level : poly) (h : R) (e : edge) : Prop :=
    eval level h < dot (values n) (place H h (fst e)) /\
    eval level h < dot (values n) (place H h (snd e)).

  Lemma exactly_beyond_correct n level H J t : near_frame r H J -> exactly_beyond r (project r n level J) t = true ->
    forall h, Rabs h <= value r -> forall e, in_tree e t -> edge_beyond H n level h e.
  Proof.
    intros N B h Hh. pose proof (near_project n level H J N) as NJ.
    assert (V : forall v, positive r (along_direction (project r n level J) v) = true -> eval level h < dot (values n) (place H h v)).
    { intros v T. pose proof (positive_correct r _ _ h R0 (near_along _ _ _ _ v NJ) T Hh) as A. rewrite vertex_along_place in A. lra. }
    induction t as [|e b c d|b t1 IH1 t2 IH2]; intros e' I; cbn [in_tree exactly_beyond] in *; [destruct I| |]; apply andb_prop in B.
    - subst. destruct B as [B1 B2]. split; [exact (V _ B1)|exact (V _ B2)].
    - destruct B as [B1 B2]. destruct I as [I|I]; [exact (IH1 B1 e' I)|exact (IH2 B2 e' I)].
  Qed.

  Lemma same_instant_of h : Rabs h <= value r -> value r <= value s -> exists u, same_instant (value s) h u.
  Proof.
    intros H S. pose proof (Rabs_within _ _ H). destruct (Req_dec (value s) 0) as [Z|Z].
    - exists 0. split; [rewrite Rabs_R0; lra|lra].
    - exists (h / value s). split; [|field; auto]. unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_right (value s)) by lra.
      apply (Rmult_le_reg_r (value s)); [lra|]. rewrite Rmult_assoc, Rinv_l by auto. lra.
  Qed.

  Lemma beyond_correct g n level H J t : value r <= value s -> near_frame r H J -> right_tree g t ->
    beyond r s n level (side_of g s J) t = true -> forall h, Rabs h <= value r -> forall e, in_tree e t -> edge_beyond H n level h e.
  Proof.
    intros S N T B h Hh e I. unfold beyond, side_of in B. cbn [grid_of place_in whole_in] in B. apply orb_prop in B.
    destruct B as [B|B]; [|eapply exactly_beyond_correct; eauto].
    destruct (same_instant_of h Hh S) as (u & U). destruct N as (NX & NY & NC & NS).
    pose proof (tree_beyond_correct g r s n level (box_of t) J _ _ _ _ NX NY NC NS t T (fun e' => right_ends g t e' T) B h u Hh U e I) as [A1 A2].
    unfold from_level in A1, A2. unfold edge_beyond, place, apply, plus, turned, values, dot; cbn [fst snd]. lra.
  Qed.

  Variables (gE gF : Z).
  Hypothesis S0 : value r <= value s.

  Lemma line_correct n level E E' : right_tree gE E -> right_tree gF E' ->
    separated r s (side_of gE s P) (side_of gF s Q) E E' (Line n level) = true -> forall h, Rabs h <= value r ->
    (forall e, in_tree e E -> dot (values n) (place F h (fst e)) < eval level h /\ dot (values n) (place F h (snd e)) < eval level h) /\
    (forall e, in_tree e E' -> eval level h < dot (values n) (place G h (fst e)) /\ eval level h < dot (values n) (place G h (snd e))).
  Proof.
    cbn [separated]. intros TE TF H h Hh. apply andb_prop in H. destruct H as [H1 H2]. split; intros e I.
    - destruct (beyond_correct _ _ _ F P E S0 NF TE H1 h Hh e I) as [A B].
      rewrite eval_pneg in A, B. unfold dot, values in *; cbn [fst snd] in *. rewrite !value_neg in A, B. lra.
    - exact (beyond_correct _ _ _ G Q E' S0 NG TF H2 h Hh e I).
  Qed.

  Definition edge_place (H : R -> frame) (h : R) (e : vertex * vertex) : point * point := (place H h (fst e), place H h (snd e)).

  (** One direction for two edges, throughout the window. *)
  Definition kept_apart (e f : vertex * vertex) : Prop := exists n, forall h, Rabs h <= value r ->
    dot n (place F h (fst e)) < dot n (place G h (fst f)) /\ dot n (place F h (fst e)) < dot n (place G h (snd f)) /\
    dot n (place F h (snd e)) < dot n (place G h (fst f)) /\ dot n (place F h (snd e)) < dot n (place G h (snd f)).

  Lemma separated_correct how : forall E E', right_tree gE E -> right_tree gF E' ->
    separated r s (side_of gE s P) (side_of gF s Q) E E' how = true ->
    forall e f, in_tree e E -> in_tree f E' -> kept_apart e f.
  Proof.
    induction how as [n level|s1 IH1 s2 IH2|s1 IH1 s2 IH2]; intros E E' TE TF H e f He Hf.
    - exists (values n). intros h Hh. destruct (line_correct n level E E' TE TF H h Hh) as [A B].
      specialize (A e He). specialize (B f Hf). lra.
    - cbn [separated] in H. destruct (halves_correct gE E TE) as (T1 & T2 & I). destruct (halves E) as [E1 E2].
      apply andb_prop in H. destruct H as [H1 H2]. destruct (I e He); [apply (IH1 E1 E')|apply (IH2 E2 E')]; auto.
    - cbn [separated] in H. destruct (halves_correct gF E' TF) as (T1 & T2 & I). destruct (halves E') as [F1 F2].
      apply andb_prop in H. destruct H as [H1 H2]. destruct (I f Hf); [apply (IH1 E F1)|apply (IH2 E F2)]; auto.
  Qed.
End Window.
