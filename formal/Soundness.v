(** What the checker accepts is free. *)

From Coq Require Import Reals ZArith List Bool PeanoNat Lra Lia Psatz.
From Taut Require Import Definitions Geometry Disjoint Numbers Models Functions Placement Outlines Whole Lines Check Separations Outside.
Import ListNotations.
Open Scope R_scope.

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

(** What is outside at an instant of the window is outside throughout it. *)
Lemma outside_kept r F G h0 h p q : Rabs h0 <= value r -> Rabs h <= value r ->
  (forall e f, In e (all_edges_of p) -> In f (all_edges_of q) -> kept_apart r F G e f) ->
  rings_outside (placed_part F h0 p) (placed_part G h0 q) -> rings_outside (placed_part F h p) (placed_part G h q).
Proof.
  intros H0 H K O rg' Hr Ne. unfold placed_part in Hr. apply in_map_iff in Hr. destruct Hr as (rg & <- & Hr).
  rewrite edges_map in Ne |- *. destruct (O (map (place F h0) rg)) as (e0 & w & He & (k & Hk & ->) & Od).
  { unfold placed_part. apply in_map. auto. }
  { rewrite edges_map. intros E. apply map_eq_nil in E. rewrite E in Ne. auto. }
  rewrite edges_map, in_map_iff in He. destruct He as (e & <- & He). cbn [fst snd] in Od. fold (between k (place F h0 (fst e)) (place F h0 (snd e))) in Od.
  exists (place F h (fst e), place F h (snd e)), (between k (place F h (fst e)) (place F h (snd e))). split.
  { apply (in_map (fun e => (place F h (fst e), place F h (snd e)))). auto. }
  split; [exists k; auto|]. rewrite <- Od. symmetry. apply odd_step. intros rg2 f Hr2 Hf.
  destruct (K e f) as (n & N); try (unfold all_edges_of; apply in_flat_map; eauto).
  exists n. destruct (N h0 H0) as (A & B & C & D). destruct (N h H) as (A' & B' & C' & D').
  assert (OE : forall h, on_edge (between k (place F h (fst e)) (place F h (snd e))) (place F h (fst e)) (place F h (snd e)))
    by (intros; exists k; auto).
  repeat split; eapply on_edge_before; eauto.
Qed.

Lemma placed_part_turned F h p : placed_part F h p = map (map (apply (F h))) (map (map values) p).
Proof. unfold placed_part. rewrite map_map. apply map_ext. intros rg. rewrite map_map. reflexivity. Qed.

Definition covered (c : list motion) (b : body) (after : bool) (t : R) (z : point) : Prop :=
  exists p q, In p (shape b) /\ in_part q (map (map values) p) /\ z = placed after c t q.

Lemma right_outline x y b : right_tree (grid (outline_of x y b)) (tree_in (outline_of x y b)).
Proof. unfold outline_of. cbn [grid tree_in]. apply tree_of_correct. Qed.
Lemma in_outline x y b p e : In p (shape b) -> In e (all_edges_of p) -> in_tree e (tree_in (outline_of x y b)).
Proof. intros Hp He. unfold outline_of. cbn [tree_in]. apply tree_of_correct. eapply in_edges_of; eauto. Qed.

Definition placed_shape (c : list motion) (after : bool) (t : R) (p : list (list vertex)) : part :=
  map (map (placed after c t)) (map (map values) p).

(** Each ring has a point outside of the other body's parts. *)
Definition all_outside (ca cb : list motion) (a b : body) (t : R) (after : bool) : Prop :=
  forall p q, In p (shape a) -> In q (shape b) ->
  rings_outside (placed_shape ca after t p) (placed_shape cb after t q) /\ rings_outside (placed_shape cb after t q) (placed_shape ca after t p).
Definition free_at (ca cb : list motion) (a b : body) (t : R) (after : bool) : Prop :=
  forall z, ~ (covered ca a after t z /\ covered cb b after t z).

(** What the checker finds in the middle of a window. *)
Lemma outside_rings ca cb a b from to mid p q :
  let F h := chain_frame from to ca (value mid + h) in let G h := chain_frame from to cb (value mid + h) in
  match chain_model from to mid zero ca, chain_model from to mid zero cb with
  | Some (P, _), Some (Q, _) => outside P Q (shape a) (shape b) && outside Q P (shape b) (shape a)
  | _, _ => false
  end = true -> In p (shape a) -> In q (shape b) ->
  rings_outside (placed_part F 0 p) (placed_part G 0 q) /\ rings_outside (placed_part G 0 q) (placed_part F 0 p).
Proof.
  intros F G. destruct (chain_model from to mid zero ca) as [[P c]|] eqn:CA; [|discriminate].
  destruct (chain_model from to mid zero cb) as [[Q d]|] eqn:CB; [|discriminate]. intros O Hp Hq. apply andb_prop in O. destruct O as [O1 O2].
  destruct (chain_correct _ _ _ _ _ _ _ zero_nonneg CA) as (MF & _). destruct (chain_correct _ _ _ _ _ _ _ zero_nonneg CB) as (MG & _).
  fold F in MF. fold G in MG.
  assert (N : forall F G p q, (forall rg, In rg p -> edges rg <> [] -> exists e k, In e (edges rg) /\ 0 <= k <= 1 /\
      odd (between k (place F 0 (fst e)) (place F 0 (snd e))) (placed_part G 0 q) = false) ->
      rings_outside (placed_part F 0 p) (placed_part G 0 q)).
  { intros F' G' p' q' N rg' Hr Ne. unfold placed_part in Hr. apply in_map_iff in Hr. destruct Hr as (rg & <- & Hr).
    rewrite edges_map in Ne |- *. destruct (N rg Hr) as (e & k & He & Hk & Od).
    { intros E. rewrite E in Ne. auto. }
    exists (place F' 0 (fst e), place F' 0 (snd e)), (between k (place F' 0 (fst e)) (place F' 0 (snd e))).
    split; [apply (in_map (fun e => (place F' 0 (fst e), place F' 0 (snd e)))); auto|]. split; [exists k; auto|exact Od]. }
  split; apply N; intros; eapply outside_correct; eauto.
Qed.

Section Window.
  Variables (begins ends : number) (ca cb : list motion) (a b : body) (w : window) (closed : bool).
  Let oa := outline_of begins ends a.
  Let ob := outline_of begins ends b.
  Hypothesis checked : check_window (placed_in (grid oa) ca) (placed_in (grid ob) cb) (tree_in oa) (tree_in ob) w = Some closed.
  Let mid := half (add (opens w) (closes w)).
  Let r := radius (opens w) (closes w).
  Let F h := chain_frame (opens w) (closes w) ca (value mid + h).
  Let G h := chain_frame (opens w) (closes w) cb (value mid + h).

  Lemma window_frames : 0 <= value r /\
    (forall p q, In p (shape a) -> In q (shape b) ->
       (forall e f, In e (all_edges_of p) -> In f (all_edges_of q) -> kept_apart r F G e f) /\
       (outside_in_window ca cb a b w = true ->
        rings_outside (placed_part F 0 p) (placed_part G 0 q) /\ rings_outside (placed_part G 0 q) (placed_part F 0 p))) /\
    forall t after, in_window (opens w) (closes w) closed after t -> exists h, Rabs h <= value r /\ proper (F h) /\ proper (G h) /\
      forall x, placed after ca t x = apply (F h) x /\ placed after cb t x = apply (G h) x.
  Proof.
    revert checked. unfold check_window, placed_in. fold r mid. set (s := round_up r).
    destruct (at_most zero r) eqn:R0; [|discriminate]. apply at_most_correct in R0. rewrite value_zero in R0.
    destruct (chain_model _ _ mid r ca) as [[P c1]|] eqn:CA; [|discriminate].
    destruct (chain_model _ _ mid r cb) as [[Q c2]|] eqn:CB; [|discriminate].
    destruct (separated r s (side_of (grid oa) s P) (side_of (grid ob) s Q) (tree_in oa) (tree_in ob) (how w)) eqn:S; [|discriminate].
    intros [= <-]. pose proof (round_up_correct r) as RU. fold s in RU.
    pose proof (right_outline begins ends a) as Ta. pose proof (right_outline begins ends b) as Tb. fold oa in Ta. fold ob in Tb.
    destruct (chain_correct _ _ _ _ _ _ _ R0 CA) as (NF & PF & AF). destruct (chain_correct _ _ _ _ _ _ _ R0 CB) as (NG & PG & AG).
    fold F in NF. fold G in NG. split; auto. split.
    - intros p q Hp Hq. split.
      + intros e f He Hf. apply (separated_correct r s R0 F G P Q NF NG _ _ RU _ _ _ Ta Tb S); eapply in_outline; eauto.
      + unfold outside_in_window. fold mid. intros O. destruct (how w) as [n level| |] eqn:HW; cbn [is_line orb] in O.
        * assert (Z : Rabs 0 <= value r) by (rewrite Rabs_R0; auto).
          destruct (line_correct r s R0 F G P Q NF NG _ _ RU n level _ _ Ta Tb S 0 Z) as [A B].
          assert (EA : forall e, In e (all_edges (placed_part F 0 p)) ->
                   dot (values n) (fst e) < eval level 0 /\ dot (values n) (snd e) < eval level 0).
          { intros e He. rewrite all_edges_placed in He. apply in_map_iff in He. destruct He as (e' & <- & He).
            apply A. eapply in_outline; eauto. }
          assert (EB : forall e, In e (all_edges (placed_part G 0 q)) ->
                   eval level 0 < dot (values n) (fst e) /\ eval level 0 < dot (values n) (snd e)).
          { intros e He. rewrite all_edges_placed in He. apply in_map_iff in He. destruct He as (e' & <- & He).
            apply B. eapply in_outline; eauto. }
          assert (Neg : forall v, dot (- fst (values n), - snd (values n)) v = - dot (values n) v) by (intros; unfold dot; simpl; ring).
          split; [apply (rings_outside_across (values n) (eval level 0))|
                  apply (rings_outside_across (- fst (values n), - snd (values n)) (- eval level 0))].
          -- intros e He. apply EA; auto.
          -- auto.
          -- intros e He. rewrite Neg. destruct (EB e He). lra.
          -- intros e He. rewrite !Neg. destruct (EA e He). lra.
        * apply (outside_rings ca cb a b (opens w) (closes w) mid); auto.
        * apply (outside_rings ca cb a b (opens w) (closes w) mid); auto.
    - intros t after W. set (h := t - value mid). assert (T : t = value mid + h) by (unfold h; ring).
      assert (H : Rabs h <= value r).
      { destruct W as [W _]. unfold h, mid, r, radius in *. rewrite value_half, value_sub in R0. rewrite !value_half, value_sub, value_add.
        apply Rabs_le. lra. }
      exists h. rewrite T in W |- *. split; auto. split; [apply PF; auto|]. split; [apply PG; auto|]. intros x. split.
      + apply AF. apply (in_window_weaken _ _ (c1 && c2)); auto. destruct c1; auto.
      + apply AG. apply (in_window_weaken _ _ (c1 && c2)); auto. destruct c1, c2; auto.
  Qed.

  Lemma placed_shape_part c (H : R -> frame) after t h p : (forall x, placed after c t x = apply (H h) x) ->
    placed_shape c after t p = placed_part H h p.
  Proof. intros E. rewrite placed_part_turned. apply map_ext. intros rg. apply map_ext. auto. Qed.

  (** What is outside at an instant of a window is outside throughout it; and then nothing is in both. *)
  Lemma check_window_correct :
    (forall t after, in_window (opens w) (closes w) closed after t -> all_outside ca cb a b t after -> free_at ca cb a b t after) /\
    (forall t after t' after', in_window (opens w) (closes w) closed after t -> in_window (opens w) (closes w) closed after' t' ->
       all_outside ca cb a b t' after' -> all_outside ca cb a b t after) /\
    (outside_in_window ca cb a b w = true ->
       forall t after, in_window (opens w) (closes w) closed after t -> all_outside ca cb a b t after) /\
    value (opens w) <= value (closes w).
  Proof.
    destruct window_frames as (R0 & K & I). split; [|split; [|split]].
    - intros t after W O z [(p & x & Hp & Ix & Ex) (q & y & Hq & Iy & Ey)].
      destruct (I t after W) as (h & Hh & PF & PG & E). destruct (K p q Hp Hq) as [Kp _]. destruct (O p q Hp Hq) as [O1 O2].
      rewrite (placed_shape_part ca F after t h) in O1, O2 by apply E. rewrite (placed_shape_part cb G after t h) in O1, O2 by apply E.
      apply (parts_disjoint (placed_part F h p) (placed_part G h q)) with (z := z); auto; [eapply kept_apart_parts; eauto|].
      rewrite Ex at 1. rewrite Ey. destruct (E x) as [-> _]. destruct (E y) as [_ ->].
      rewrite !placed_part_turned. split; apply in_part_turned; auto.
    - intros t after t' after' W W' O p q Hp Hq. destruct (I t after W) as (h & Hh & _ & _ & E). destruct (I t' after' W') as (h' & Hh' & _ & _ & E').
      destruct (K p q Hp Hq) as [Kp _]. destruct (O p q Hp Hq) as [O1 O2].
      rewrite (placed_shape_part ca F after' t' h'), (placed_shape_part cb G after' t' h') in O1, O2 by apply E'.
      rewrite (placed_shape_part ca F after t h), (placed_shape_part cb G after t h) by apply E.
      split; [apply (outside_kept r F G h' h)|apply (outside_kept r G F h' h)]; auto. intros. apply kept_apart_sym. auto.
    - intros O t after W p q Hp Hq. destruct (I t after W) as (h & Hh & _ & _ & E). destruct (K p q Hp Hq) as [Kp M].
      destruct (M O) as [O1 O2]. rewrite (placed_shape_part ca F after t h), (placed_shape_part cb G after t h) by apply E.
      assert (Z : Rabs 0 <= value r) by (rewrite Rabs_R0; auto).
      split; [apply (outside_kept r F G 0 h)|apply (outside_kept r G F 0 h)]; auto. intros. apply kept_apart_sym. auto.
    - unfold r, radius in R0. rewrite value_half, value_sub in R0. lra.
  Qed.
End Window.

Lemma check_windows_correct check outside (safe out : R -> bool -> Prop) stop l :
  (forall w closed, check w = Some closed ->
     (forall t after, in_window (opens w) (closes w) closed after t -> out t after -> safe t after) /\
     (forall t after t' after', in_window (opens w) (closes w) closed after t -> in_window (opens w) (closes w) closed after' t' ->
        out t' after' -> out t after) /\
     (outside w = true -> forall t after, in_window (opens w) (closes w) closed after t -> out t after) /\
     value (opens w) <= value (closes w)) ->
  forall time known, check_windows check outside time known stop l = true -> (known = true -> out (value time) true) ->
  forall t after, value time <= t <= value stop -> (after = false -> value time < t) -> safe t after.
Proof.
  intros C. induction l as [|w l IH]; intros time known H Known t after T A; [discriminate|].
  cbn [check_windows] in H. apply andb_prop in H. destruct H as [H1 H2]. apply at_most_correct in H1.
  destruct (check w) as [closed|] eqn:E; [|discriminate]. destruct (C w closed E) as (Safe & Kept & Begin & Order).
  apply andb_prop in H2. destruct H2 as [H2 H3].
  assert (Out : forall t after, in_window (opens w) (closes w) closed after t -> out t after).
  { apply orb_prop in H2. destruct H2 as [H2|H2]; [|apply Begin; auto].
    rewrite !andb_true_iff in H2. destruct H2 as [[-> M] N]. apply at_most_correct in M.
    intros t' after' W. apply (Kept t' after' (value time) true); auto. split; [lra|]. split; [|discriminate].
    intros _. apply orb_prop in N. destruct N as [N|N]; auto. apply below_correct in N. auto. }
  assert (D : in_window (opens w) (closes w) closed after t \/ (value (closes w) < t \/ (t = value (closes w) /\ after = true /\ closed = false))).
  { unfold in_window. destruct (Rtotal_order t (value (closes w))) as [L|[L|L]]; [left| |right; left; lra].
    - repeat split; try lra; auto. intros F. specialize (A F). lra.
    - destruct after, closed; [left|right; right; auto|left|left]; repeat split; try lra; auto; try discriminate.
      all: intros F; specialize (A F); lra. }
  destruct D as [D|D]; [auto|].
  apply orb_prop in H3. destruct H3 as [H3|H3].
  - exfalso. apply andb_prop in H3. destruct H3 as [M N]. apply at_most_correct in M. apply orb_prop in N.
    destruct D as [D|(D1 & D2 & D3)]; [lra|]. destruct N as [N|N]; [congruence|]. apply below_correct in N. lra.
  - apply (IH (closes w) closed); auto; [|destruct D as [D|(D & _)]; lra|].
    + intros ->. apply Out. split; [lra|]. split; auto. discriminate.
    + intros F. destruct D as [D|(_ & D & _)]; [lra|congruence].
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

Lemma without_common_whole c d c' d' : without_common c d = (c', d') ->
  ((length c' <= length c)%nat /\ (length c' = length c -> c' = c)) /\ ((length d' <= length d)%nat /\ (length d' = length d -> d' = d)).
Proof.
  revert d; induction c as [|m c IH]; intros d; [intros [= <- <-]; auto|].
  destruct d as [|n d]; [intros [= <- <-]; auto|]. cbn [without_common].
  destruct (regular m); [|intros [= <- <-]; auto]. destruct (motion_eq m n) as [<-|]; [|intros [= <- <-]; auto].
  intros E. destruct (IH d E) as [[L _] [M _]]. simpl. repeat split; lia.
Qed.
Lemma placed_outline_correct x y b c opens closes : (length c = length (chain b) -> c = chain b) ->
  placed_outline (outline_of x y b) (same_length c (chain b)) c opens closes = placed_in (grid (outline_of x y b)) c opens closes.
Proof.
  intros L. unfold placed_outline, same_length. destruct (Nat.eqb_spec (length c) (length (chain b))) as [E|]; auto.
  rewrite (L E). cbn [andb from to outline_of]. destruct (number_eq opens x) as [->|]; auto. destruct (number_eq closes y) as [->|]; auto.
Qed.

Definition disjoint_until (s : scene) (stop : number) (a b : body) : Prop :=
  forall t after, value (start s) <= t <= value stop -> (after = false -> value (start s) < t) ->
  forall z, ~ (covers a after t z /\ covers b after t z).

Lemma check_pair_correct s begins ends stop i a j b l l' :
  check_pair s stop (i, (a, outline_of begins ends a)) (j, (b, outline_of begins ends b)) l = Some l' -> tested s i j a b -> disjoint_until s stop a b.
Proof.
  unfold check_pair. intros H T. rewrite (is_tested_correct _ _ _ _ _ T) in H. destruct l as [|[ij windows] rest]; [discriminate|].
  destruct (without_common (chain a) (chain b)) as [ca cb] eqn:E. destruct (is_pair i j ij); [|discriminate]. simpl in H.
  destruct (check_windows _ _ _ _ _ _) eqn:W; [|discriminate]. intros t after Ht A z [(p & x & Hp & Ix & Ex) (q & y & Hq & Iy & Ey)].
  destruct (without_common_whole _ _ _ _ E) as [[_ La] [_ Lb]].
  assert (same : forall w closed, check_window (placed_outline (outline_of begins ends a) (same_length ca (chain a)) ca)
      (placed_outline (outline_of begins ends b) (same_length cb (chain b)) cb) (tree_in (outline_of begins ends a)) (tree_in (outline_of begins ends b)) w = Some closed ->
    check_window (placed_in (grid (outline_of begins ends a)) ca) (placed_in (grid (outline_of begins ends b)) cb)
      (tree_in (outline_of begins ends a)) (tree_in (outline_of begins ends b)) w = Some closed).
  { intros w closed. unfold check_window. rewrite !placed_outline_correct by auto. auto. }
  pose proof (check_windows_correct _ _ (free_at ca cb a b) (all_outside ca cb a b) _ _
    (fun w closed C => check_window_correct begins ends ca cb a b w closed (same w closed C)) _ _ W ltac:(discriminate) t after Ht A) as N.
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

Lemma number_bodies_nth x y l k i b :
  nth_error l i = Some b -> nth_error (number_bodies x y k l) i = Some ((k + i)%nat, (b, outline_of x y b)).
Proof.
  revert k i; induction l as [|b' l IH]; intros k i; [destruct i; discriminate|]. destruct i as [|i]; simpl.
  - intros [= ->]. rewrite Nat.add_0_r. reflexivity.
  - intros E. rewrite (IH (S k) i E). f_equal. f_equal. lia.
Qed.

Theorem accepted_is_free : forall (s : scene) (l : log), check s l = true -> free_until s (value (proved_until l)).
Proof.
  intros s l H. unfold check in H. destruct (check_rows _ _ _ _) as [rest|] eqn:C; [|discriminate]. clear H.
  intros t after Ht A i j a b T z. pose proof T as (L & Na & Nb & _).
  apply (number_bodies_nth (start s) (proved_until l) _ 0) in Na, Nb. simpl in Na, Nb.
  destruct (nth_error_split _ _ Na) as (before & following & E & Len).
  assert (I : In (j, (b, outline_of (start s) (proved_until l) b)) following).
  { rewrite E, nth_error_app2 in Nb by lia. destruct (j - length before)%nat eqn:D; [lia|]. simpl in Nb. eapply nth_error_In; eauto. }
  destruct (check_rows_correct _ _ _ _ _ C _ _ _ _ E I) as (m & m' & P).
  apply (check_pair_correct s (start s) (proved_until l) (proved_until l) i a j b m m'); auto.
Qed.
