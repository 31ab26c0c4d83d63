(** Models of where a chain of motions puts a body, in a window of time. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
From Taut Require Import Definitions Geometry Numbers Models Functions.
Import ListNotations.
Open Scope R_scope.

(** * Frames of pieces *)

Definition identity : frame := Frame (0, 0) (1, 0).
Definition compose (f g : frame) : frame := Frame (plus (at_ f) (turned (along f) (at_ g))) (turned (along f) (along g)).
Definition place_of_pivot (m : piece) (t : R) : point :=
  let x := t - value (origin m) in
  let moved := plus (values (pivot m)) (eval (fst (shift m)) x, eval (snd (shift m)) x) in
  match orbit m with
  | None => moved
  | Some (centre, a) => plus (values centre) (turned (cos (eval a x), sin (eval a x)) (minus moved (values centre)))
  end.
Definition frame_of (m : piece) (t : R) : frame :=
  let cs := cos_sin (turn m) (t - value (origin m)) in
  Frame (minus (place_of_pivot m t) (turned cs (values (pivot m)))) cs.

Lemma pose_frame m t p : pose m t p = apply (frame_of m t) p.
Proof.
  unfold pose, frame_of, apply. fold (place_of_pivot m t). unfold plus, minus, turned; cbn [at_ along fst snd]. f_equal; ring.
Qed.
Lemma apply_identity p : apply identity p = p.
Proof. destruct p. unfold apply, identity, plus, turned; simpl. f_equal; ring. Qed.
Lemma apply_compose f g p : apply (compose f g) p = apply f (apply g p).
Proof. unfold apply, compose, plus, turned; simpl. f_equal; ring. Qed.
Lemma proper_identity : proper identity.
Proof. unfold proper; simpl. lra. Qed.
Lemma proper_compose f g : proper f -> proper g -> proper (compose f g).
Proof.
  unfold proper, compose, turned; simpl. intros F G.
  replace (_ + _) with ((fst (along f) * fst (along f) + snd (along f) * snd (along f)) *
                        (fst (along g) * fst (along g) + snd (along g) * snd (along g))) by ring.
  apply Rmult_lt_0_compat; auto.
Qed.
Lemma apply_injective f p q : proper f -> apply f p = apply f q -> p = q.
Proof.
  unfold proper, apply, plus, turned. destruct f as [o [c s]], p as [x y], q as [x' y']; simpl. intros P E.
  injection E; intros E2 E1.
  assert (A : c * (x - x') = s * (y - y')) by lra. assert (B : s * (x - x') = - (c * (y - y'))) by lra.
  assert (X : (c * c + s * s) * (x - x') = 0).
  { replace ((c * c + s * s) * (x - x')) with (c * (c * (x - x')) + s * (s * (x - x'))) by ring. rewrite A, B. ring. }
  assert (Y : (c * c + s * s) * (y - y') = 0).
  { replace ((c * c + s * s) * (y - y')) with (s * (s * (y - y')) - c * (- (c * (y - y')))) by ring. rewrite <- A, <- B. ring. }
  apply Rmult_integral in X, Y. f_equal; lra.
Qed.

(** Rotations that always are one: a direction may vanish. *)
Definition regular_rotation (turn : rotation) : bool :=
  match turn with
  | Direction [a] [b] => negb (Z.eqb (mantissa a) 0 && Z.eqb (mantissa b) 0)
  | Direction _ _ => false
  | _ => true
  end.
Definition regular (m : motion) : bool := match m with [] => false | _ => forallb (fun p => regular_rotation (turn p)) m end.

Lemma proper_turn m t : regular_rotation (turn m) = true -> proper (frame_of m t).
Proof.
  unfold proper, frame_of; simpl. destruct (turn m) as [|a|s|a b|a]; cbn [cos_sin fst snd]; intros H.
  - lra.
  - pose proof (sin2_cos2 (eval a (t - value (origin m)))) as E. unfold Rsqr in E. lra.
  - set (x := eval s _). assert (P : 0 < 1 + x * x) by nra.
    replace (_ + _) with 1 by (field; lra). lra.
  - destruct a as [|a [|]], b as [|b [|]]; try discriminate. cbn [eval]. rewrite !Rmult_0_r, !Rplus_0_r.
    assert (S : value a <> 0 \/ value b <> 0).
    { simpl in H. destruct (Z.eqb_spec (mantissa a) 0) as [A|A].
      - destruct (Z.eqb_spec (mantissa b) 0) as [B|B]; [discriminate|]. right. apply value_nonzero; auto.
      - left. apply value_nonzero; auto. }
    set (x := value a) in *. set (y := value b) in *. clearbody x y.
    assert (P : 0 < x * x + y * y) by (destruct (Req_dec x 0); [destruct (Req_dec y 0); [tauto|nra]|nra]).
    assert (L : 0 < sqrt (x * x + y * y)) by (apply sqrt_lt_R0; auto).
    pose proof (sqrt_sqrt (x * x + y * y) ltac:(lra)) as Q. set (n := sqrt _) in *.
    replace (_ + _) with ((x * x + y * y) / (n * n)) by (field; lra). rewrite Q. unfold Rdiv. rewrite Rinv_r; lra.
  - fold (clamp (eval a (t - value (origin m)))). set (c := clamp _). pose proof (clamp_range (eval a (t - value (origin m)))) as C.
    fold c in C. rewrite sqrt_sqrt by nra. lra.
Qed.

Lemma piece_at_in after m t p : piece_at after m t = Some p -> In p m.
Proof.
  revert p; induction m as [|q [|q' m] IH]; intros p; [discriminate|intros [= <-]; left; auto|].
  cbn [piece_at]. destruct (if after then _ else _); [intros [= <-]; left; auto|intros E; right; apply IH; auto].
Qed.

Lemma regular_follow after m t p q : regular m = true -> follow after m t p = follow after m t q -> p = q.
Proof.
  unfold follow. destruct (piece_at after m t) as [piece|] eqn:E; auto. intros Rg. rewrite !pose_frame. apply apply_injective, proper_turn.
  apply piece_at_in in E. destruct m; [destruct E|]. unfold regular in Rg. rewrite forallb_forall in Rg. exact (Rg _ E).
Qed.

(** * Models of frames *)

Record placement := Placement { ox : model; oy : model; co : model; si : model }.
Definition near_frame (r : number) (F : R -> frame) (P : placement) : Prop :=
  near r (fun h => fst (at_ (F h))) (ox P) /\ near r (fun h => snd (at_ (F h))) (oy P) /\
  near r (fun h => fst (along (F h))) (co P) /\ near r (fun h => snd (along (F h))) (si P).

Definition identity_model : placement := Placement (constant zero) (constant zero) (constant one) (constant zero).
Definition turned_model (r : number) (c s x y : model) : model * model :=
  (msub (mmul r c x) (mmul r s y), madd (mmul r s x) (mmul r c y)).
Definition compose_models (r : number) (P Q : placement) : placement :=
  let (x, y) := turned_model r (co P) (si P) (ox Q) (oy Q) in
  let (c, s) := turned_model r (co P) (si P) (co Q) (si Q) in
  Placement (madd (ox P) x) (madd (oy P) y) c s.

(** The polynomial p in (middle + h - origin). *)
Definition poly_model (r d : number) (p : poly) : model := tidy r (Model (pshift d p) zero).
Definition cos_sin_of (r d : number) (turn : rotation) : option (model * model) :=
  match turn with
  | Fixed => Some (constant one, constant zero)
  | Angle a => cos_sin_model r (poly_model r d a)
  | HalfAngleTangent p =>
      let s := poly_model r d p in
      let q := mmul r s s in
      let i := reciprocal r (madd (constant one) q) in
      Some (mmul r (msub (constant one) q) i, mmul r (mscale (Number 1 1) s) i)
  | Direction a b =>
      let A := poly_model r d a in let B := poly_model r d b in
      match reciprocal_root r (madd (mmul r A A) (mmul r B B)) with
      | None => None
      | Some i => Some (mmul r A i, mmul r B i)
      end
  | Cosine a =>
      let C := clamp_model r (poly_model r d a) in
      match root_model r (msub (constant one) (mmul r C C)) with
      | None => None
      | Some s => Some (C, s)
      end
  end.
Definition piece_model (middle r : number) (m : piece) : option placement :=
  let d := sub middle (origin m) in
  let px := constant (fst (pivot m)) in let py := constant (snd (pivot m)) in
  let mx := madd px (poly_model r d (fst (shift m))) in
  let my := madd py (poly_model r d (snd (shift m))) in
  let place :=
    match orbit m with
    | None => Some (mx, my)
    | Some (centre, a) =>
        let cx := constant (fst centre) in let cy := constant (snd centre) in
        match cos_sin_model r (poly_model r d a) with
        | None => None
        | Some (c, s) => let (x, y) := turned_model r c s (msub mx cx) (msub my cy) in Some (madd cx x, madd cy y)
        end
    end in
  match place, cos_sin_of r d (turn m) with
  | Some (x, y), Some (c, s) =>
      let (qx, qy) := turned_model r c s px py in
      Some (Placement (tidy r (msub x qx)) (tidy r (msub y qy)) c s)
  | _, _ => None
  end.

(** The piece that holds throughout the window [a, b], and whether it does so at the instant b and after it, too. *)
Fixpoint locate (a b : number) (m : motion) : option (piece * bool) :=
  match m with
  | [] => None
  | [last] => Some (last, true)
  | p :: rest =>
      if at_most (until p) a then locate a b rest
      else if at_most b (until p) then Some (p, below b (until p)) else None
  end.

Fixpoint chain_model (a b middle r : number) (c : list motion) : option (placement * bool) :=
  match c with
  | [] => Some (identity_model, true)
  | m :: rest =>
      match locate a b m, chain_model a b middle r rest with
      | Some (p, closed), Some (Q, closed') =>
          match piece_model middle r p with
          | None => None
          | Some P => Some (match rest with [] => P | _ => compose_models r P Q end, closed && closed')
          end
      | _, _ => None
      end
  end.

(** * Correctness *)

Section Correctness.
  Variable r : number.
  Hypothesis R : 0 <= value r.

  Lemma near_zero : near r (fun _ => 0) (constant zero).
  Proof. apply (near_ext r (fun _ => value zero)); [intros; apply value_zero|apply near_constant]. Qed.

  Lemma near_turned c s x y C S X Y : near r c C -> near r s S -> near r x X -> near r y Y ->
    near r (fun h => fst (turned (c h, s h) (x h, y h))) (fst (turned_model r C S X Y)) /\
    near r (fun h => snd (turned (c h, s h) (x h, y h))) (snd (turned_model r C S X Y)).
  Proof.
    intros HC HS HX HY. unfold turned, turned_model; simpl. split.
    - apply (near_msub r (fun h => c h * x h)); apply near_mmul; auto.
    - apply (near_madd r (fun h => s h * x h)); apply near_mmul; auto.
  Qed.

  Lemma near_identity : near_frame r (fun _ => identity) identity_model.
  Proof. repeat split; simpl; auto using near_zero, one_near. Qed.

  Lemma near_compose F G P Q : near_frame r F P -> near_frame r G Q ->
    near_frame r (fun h => compose (F h) (G h)) (compose_models r P Q).
  Proof.
    intros (F1 & F2 & F3 & F4) (G1 & G2 & G3 & G4). unfold compose_models.
    destruct (near_turned _ _ _ _ _ _ _ _ F3 F4 G1 G2) as [X Y]. destruct (near_turned _ _ _ _ _ _ _ _ F3 F4 G3 G4) as [C S].
    destruct (turned_model r (co P) (si P) (ox Q) (oy Q)) as [x y]. destruct (turned_model r (co P) (si P) (co Q) (si Q)) as [c s].
    unfold near_frame, compose, plus; cbn [ox oy co si at_ along fst snd] in *.
    repeat split.
    - apply (near_madd r (fun h => fst (at_ (F h)))); auto.
    - apply (near_madd r (fun h => snd (at_ (F h)))); auto.
    - exact C.
    - exact S.
  Qed.

  Lemma near_poly middle o p : near r (fun h => eval p (value middle + h - value o)) (poly_model r (sub middle o) p).
  Proof.
    apply near_tidy; auto. apply (near_ext r (eval (pshift (sub middle o) p))); [|apply near_eval].
    intros h. rewrite eval_pshift, value_sub. f_equal. ring.
  Qed.

  Lemma near_cos_sin_of middle o turn c s : cos_sin_of r (sub middle o) turn = Some (c, s) ->
    near r (fun h => fst (cos_sin turn (value middle + h - value o))) c /\
    near r (fun h => snd (cos_sin turn (value middle + h - value o))) s /\
    forall h, Rabs h <= value r ->
      0 < fst (cos_sin turn (value middle + h - value o)) * fst (cos_sin turn (value middle + h - value o)) +
          snd (cos_sin turn (value middle + h - value o)) * snd (cos_sin turn (value middle + h - value o)).
  Proof.
    destruct turn as [|a|p|a b|a].
    - intros [= <- <-]. simpl. repeat split; auto using near_zero, one_near. intros; lra.
    - intros E. destruct (near_cos_sin_model r R _ _ _ _ (near_poly middle o a) E) as [C S]. repeat split; auto.
      intros h _. simpl. set (x := eval a _). pose proof (sin2_cos2 x) as T. unfold Rsqr in T. lra.
    - cbn [cos_sin_of]. intros [= <- <-]. set (f := fun h => eval p (value middle + h - value o)).
      pose proof (near_poly middle o p) as N. fold f in N.
      assert (Q : near r (fun h => f h * f h) (mmul r (poly_model r (sub middle o) p) (poly_model r (sub middle o) p)))
        by (apply near_mmul; auto).
      assert (D : near r (fun h => 1 + f h * f h)
                       (madd (constant one) (mmul r (poly_model r (sub middle o) p) (poly_model r (sub middle o) p))))
        by (apply (near_madd r (fun _ => 1)); auto using one_near).
      pose proof (near_reciprocal r R _ _ D ltac:(intros; simpl; nra)) as I. simpl. repeat split.
      + apply (near_mmul r R (fun h => 1 - f h * f h) (fun h => / (1 + f h * f h))); auto.
        apply (near_msub r (fun _ => 1)); auto using one_near.
      + apply (near_mmul r R (fun h => 2 * f h) (fun h => / (1 + f h * f h))); auto.
        apply (near_ext r (fun h => value (Number 1 1) * f h)); [intros; rewrite value_two; auto|]. apply near_mscale; auto.
      + intros h _. fold (f h). set (x := f h). assert (P : 0 < 1 + x * x) by nra. replace (_ + _) with 1 by (field; lra). lra.
    - cbn [cos_sin_of]. set (f := fun h => eval a (value middle + h - value o)). set (g := fun h => eval b (value middle + h - value o)).
      pose proof (near_poly middle o a) as NA. fold f in NA. pose proof (near_poly middle o b) as NB. fold g in NB.
      set (A := poly_model r (sub middle o) a) in *. set (B := poly_model r (sub middle o) b) in *.
      destruct (reciprocal_root r (madd (mmul r A A) (mmul r B B))) as [i|] eqn:E; [|discriminate]. intros [= <- <-].
      assert (N : near r (fun h => f h * f h + g h * g h) (madd (mmul r A A) (mmul r B B)))
        by (apply (near_madd r (fun h => f h * f h)); apply near_mmul; auto).
      destruct (near_reciprocal_root r R _ _ _ N ltac:(intros; simpl; nra) E) as [I P].
      repeat split.
      + apply (near_mmul r R f (fun h => / sqrt (f h * f h + g h * g h))); auto.
      + apply (near_mmul r R g (fun h => / sqrt (f h * f h + g h * g h))); auto.
      + intros h H. specialize (P h H). simpl in P. simpl. fold (f h). fold (g h).
        assert (L : 0 < sqrt (f h * f h + g h * g h)) by (apply sqrt_lt_R0; auto).
        pose proof (sqrt_sqrt (f h * f h + g h * g h) ltac:(lra)) as Q. set (n := sqrt _) in *.
        replace (_ + _) with ((f h * f h + g h * g h) / (n * n)) by (field; lra). rewrite Q.
        unfold Rdiv. rewrite Rinv_r; lra.
    - cbn [cos_sin_of]. set (f := fun h => clamp (eval a (value middle + h - value o))).
      pose proof (near_clamp r R _ _ (near_poly middle o a)) as N. fold f in N.
      set (C := clamp_model r (poly_model r (sub middle o) a)) in *. clearbody C.
      assert (D : near r (fun h => 1 - f h * f h) (msub (constant one) (mmul r C C)))
        by (apply (near_msub r (fun _ => 1)); auto using one_near; apply near_mmul; auto).
      assert (P : forall h, 0 <= 1 - f h * f h).
      { intros h. pose proof (clamp_range (eval a (value middle + h - value o))) as B. fold (f h) in B. nra. }
      destruct (root_model r _) as [s'|] eqn:E; [|discriminate]. intros [= <- <-].
      split; [exact N|]. split; [exact (near_root r R _ _ _ D P E)|].
      intros h _. change (0 < f h * f h + sqrt (1 - f h * f h) * sqrt (1 - f h * f h)). rewrite sqrt_sqrt by auto. lra.
  Qed.

  Lemma near_values p : near r (fun _ => fst (values p)) (constant (fst p)) /\ near r (fun _ => snd (values p)) (constant (snd p)).
  Proof. split; apply near_constant. Qed.

  Lemma near_piece middle m P : piece_model middle r m = Some P ->
    near_frame r (fun h => frame_of m (value middle + h)) P /\
    forall h, Rabs h <= value r -> proper (frame_of m (value middle + h)).
  Proof.
    unfold piece_model. set (d := sub middle (origin m)).
    destruct (near_values (pivot m)) as [PX PY].
    pose proof (near_poly middle (origin m) (fst (shift m))) as SX. pose proof (near_poly middle (origin m) (snd (shift m))) as SY.
    pose proof (near_madd r _ _ _ _ PX SX) as MX. pose proof (near_madd r _ _ _ _ PY SY) as MY. fold d in MX, MY.
    set (mx := madd _ (poly_model r d (fst (shift m)))) in *. set (my := madd _ (poly_model r d (snd (shift m)))) in *.
    set (place := match orbit m with None => _ | Some _ => _ end).
    assert (L : forall x y, place = Some (x, y) -> near r (fun h => fst (place_of_pivot m (value middle + h))) x /\
                                                   near r (fun h => snd (place_of_pivot m (value middle + h))) y).
    { unfold place, place_of_pivot. destruct (orbit m) as [[centre a]|]; [|intros x y [= <- <-]; auto].
      intros x y. destruct (cos_sin_model r (poly_model r d a)) as [[c s]|] eqn:E; [|discriminate].
      destruct (near_cos_sin_model r R _ _ _ _ (near_poly middle (origin m) a) E) as [C S].
      destruct (near_values centre) as [CX CY].
      pose proof (near_msub r _ _ _ _ MX CX) as DX. pose proof (near_msub r _ _ _ _ MY CY) as DY.
      destruct (near_turned _ _ _ _ _ _ _ _ C S DX DY) as [X Y].
      destruct (turned_model r c s _ _) as [x' y']. intros [= <- <-]. split.
      - apply (near_madd r (fun _ => _) _ _ _ CX X).
      - apply (near_madd r (fun _ => _) _ _ _ CY Y). }
    destruct place as [[x y]|]; [|discriminate]. destruct (L x y eq_refl) as [X Y].
    destruct (cos_sin_of r d (turn m)) as [[c s]|] eqn:E; [|discriminate].
    destruct (near_cos_sin_of middle (origin m) (turn m) c s E) as (C & S & P0).
    pose proof (near_turned _ _ _ _ _ _ _ _ C S PX PY) as T. destruct (turned_model r c s _ _) as [qx qy].
    destruct T as [QX QY]. intros [= <-]. split; [|exact P0]. unfold near_frame, frame_of. cbn [ox oy co si at_ along fst snd] in *.
    repeat split; auto; apply near_tidy; auto.
    - apply (near_msub r (fun h => fst (place_of_pivot m (value middle + h))) _ _ _ X). exact QX.
    - apply (near_msub r (fun h => snd (place_of_pivot m (value middle + h))) _ _ _ Y). exact QY.
  Qed.
End Correctness.

(** An instant at which a window's pieces hold. *)
Definition in_window (a b : number) (closed after : bool) (t : R) : Prop :=
  value a <= t <= value b /\ (after = true -> t < value b \/ closed = true) /\ (after = false -> value a < t).

Lemma locate_correct a b m p closed : locate a b m = Some (p, closed) ->
  forall t after, in_window a b closed after t -> piece_at after m t = Some p.
Proof.
  intros E t after (T & A & B). revert E. induction m as [|q [|q' m] IH]; [discriminate|intros [= <- <-]; auto|].
  cbn [locate piece_at]. destruct (at_most (until q) a) eqn:U.
  - intros E. apply at_most_correct in U.
    assert (F : (if after then less t (value (until q)) else negb (less (value (until q)) t)) = false).
    { destruct after; [apply less_false; lra|]. specialize (B eq_refl). apply negb_false_iff, less_true. lra. }
    rewrite F. apply IH; auto.
  - destruct (at_most b (until q)) eqn:V; [|discriminate]. intros [= <- <-]. apply at_most_correct in V.
    assert (F : (if after then less t (value (until q)) else negb (less (value (until q)) t)) = true).
    { destruct after; [apply less_true|apply negb_true_iff, less_false; lra].
      destruct (A eq_refl) as [L|L]; [lra|]. apply below_correct in L. lra. }
    rewrite F. reflexivity.
Qed.

Lemma in_window_weaken a b closed closed' after t : (closed = true -> closed' = true) ->
  in_window a b closed after t -> in_window a b closed' after t.
Proof. unfold in_window. intuition. Qed.

(** The frame that the pieces of a window give at an instant. *)
Fixpoint chain_frame (a b : number) (c : list motion) (t : R) : frame :=
  match c with
  | [] => identity
  | m :: rest =>
      match locate a b m with
      | Some (p, _) => match rest with [] => frame_of p t | _ => compose (frame_of p t) (chain_frame a b rest t) end
      | None => identity
      end
  end.

(** It is what the model is of, and where the chain puts a body, for both sides of all instants of a window. *)
Lemma chain_correct a b middle r c P closed : 0 <= value r -> chain_model a b middle r c = Some (P, closed) ->
  near_frame r (fun h => chain_frame a b c (value middle + h)) P /\
  (forall h, Rabs h <= value r -> proper (chain_frame a b c (value middle + h))) /\
  forall h after q, in_window a b closed after (value middle + h) ->
    placed after c (value middle + h) q = apply (chain_frame a b c (value middle + h)) q.
Proof.
  intros R. revert P closed; induction c as [|m c IH]; intros P closed.
  - intros [= <- <-]. split; [apply near_identity; auto|]. split.
    + intros; apply proper_identity.
    + intros. cbn [chain_frame]. rewrite apply_identity. reflexivity.
  - cbn [chain_model chain_frame]. destruct (locate a b m) as [[p closed1]|] eqn:L; [|discriminate].
    destruct (chain_model a b middle r c) as [[Q closed2]|]; [|discriminate].
    destruct (piece_model middle r p) as [P'|] eqn:M; [|discriminate]. intros E.
    destruct (near_piece r R middle p P' M) as [N Pr]. destruct (IH Q closed2 eq_refl) as (NG & PG & AG).
    assert (Fo : forall h after q, in_window a b closed after (value middle + h) ->
                 placed after (m :: c) (value middle + h) q = apply (frame_of p (value middle + h)) (placed after c (value middle + h) q)).
    { intros h after q W. injection E; intros E1 E2. change (placed after (m :: c) (value middle + h) q) with
        (follow after m (value middle + h) (placed after c (value middle + h) q)).
      unfold follow. rewrite (locate_correct a b m p closed1 L).
      - apply pose_frame.
      - apply (in_window_weaken a b closed); auto. intros ->. destruct closed1; auto. }
    destruct c as [|m' c].
    + injection E; intros E1 E2. subst P. auto.
    + injection E; intros E1 E2. subst P.
      split; [apply (near_compose r R (fun h => frame_of p (value middle + h))); auto|]. split; [intros; apply proper_compose; auto|].
      intros h after q W. rewrite Fo, apply_compose by auto. f_equal. apply AG.
      apply (in_window_weaken a b closed); auto. intros ->. destruct closed1, closed2; auto.
Qed.
