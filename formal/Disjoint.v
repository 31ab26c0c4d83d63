(** Two parts whose boundaries are apart are disjoint if each ring of either has a point outside of the other part. *)

From Coq Require Import Reals ZArith List Bool Lra Psatz.
From Taut Require Import Definitions Geometry.
Import ListNotations.
Open Scope R_scope.

(** A direction with the first edge before the second one. *)
Definition edges_apart (e f : point * point) : Prop := exists n,
  dot n (fst e) < dot n (fst f) /\ dot n (fst e) < dot n (snd f) /\
  dot n (snd e) < dot n (fst f) /\ dot n (snd e) < dot n (snd f).
Definition all_edges {A} (p : list (list A)) : list (A * A) := flat_map edges p.
Definition apart (p q : part) : Prop := forall e f, In e (all_edges p) -> In f (all_edges q) -> edges_apart e f.
Definition rings_outside (p q : part) : Prop :=
  forall r, In r p -> edges r <> [] -> exists e w, In e (edges r) /\ on_edge w (fst e) (snd e) /\ odd w q = false.

Lemma in_all_edges {A} (p : list (list A)) e : In e (all_edges p) <-> exists r, In r p /\ In e (edges r).
Proof. unfold all_edges. rewrite in_flat_map. reflexivity. Qed.

Lemma apart_sym p q : apart p q -> apart q p.
Proof.
  intros H e f He Hf. destruct (H f e Hf He) as (n & H1 & H2 & H3 & H4).
  exists (- fst n, - snd n). unfold dot in *; simpl; repeat split; lra.
Qed.

Lemma dot_between n k u v : dot n (between k u v) = (1 - k) * dot n u + k * dot n v.
Proof. unfold dot, between; simpl; ring. Qed.

Lemma on_edge_before n w u v x : on_edge w u v -> dot n u < x -> dot n v < x -> dot n w < x.
Proof.
  intros (k & Hk & ->) Hu Hv. change (dot n (between k u v) < x). rewrite dot_between.
  destruct (Req_dec k 0); [subst; lra|]. assert (k * dot n v < k * x) by (apply Rmult_lt_compat_l; lra). nra.
Qed.
Lemma on_edge_after n w u v x : on_edge w u v -> x < dot n u -> x < dot n v -> x < dot n w.
Proof.
  intros (k & Hk & ->) Hu Hv. change (x < dot n (between k u v)). rewrite dot_between.
  destruct (Req_dec k 0); [subst; lra|]. assert (k * x < k * dot n v) by (apply Rmult_lt_compat_l; lra). nra.
Qed.

Lemma map_map_id {A} (p : list (list A)) : map (map (fun x => x)) p = p.
Proof. rewrite (map_ext _ (fun r => r)) by apply map_id. apply map_id. Qed.

Lemma odd_along_edge p q e w w' : apart p q -> In e (all_edges p) ->
  on_edge w (fst e) (snd e) -> on_edge w' (fst e) (snd e) -> odd w q = odd w' q.
Proof.
  intros H He Hw Hw'. rewrite <- (map_map_id q). apply odd_step.
  intros r f Hr Hf. destruct (H e f He) as (n & H1 & H2 & H3 & H4); [apply in_all_edges; eauto|].
  exists n. repeat split; eapply on_edge_before; eauto.
Qed.

Lemma on_edge_first u v : on_edge u u v.
Proof. exists 0. split; [lra|]. destruct u; simpl; f_equal; ring. Qed.
Lemma on_edge_second u v : on_edge v u v.
Proof. exists 1. split; [lra|]. destruct v; simpl; f_equal; ring. Qed.

Lemma odd_along_steps p q first r : apart p q -> (forall e, In e (steps first r) -> In e (all_edges p)) ->
  forall e, In e (steps first r) -> odd (fst e) q = match r with [] => false | u :: _ => odd u q end.
Proof.
  intros H. induction r as [|u r IH]; [intros _ e []|]. intros S e [<-|I]; auto.
  rewrite (IH (fun e' I' => S e' (or_intror I')) e I). destruct r as [|v r]; [destruct I|].
  apply (odd_along_edge p q (u, v)); auto.
  - apply S. left; reflexivity.
  - apply on_edge_second.
  - apply on_edge_first.
Qed.

Lemma outside_everywhere p q : apart p q -> rings_outside p q ->
  forall e w, In e (all_edges p) -> on_edge w (fst e) (snd e) -> odd w q = false.
Proof.
  intros H O e w He Hw. destruct (proj1 (in_all_edges p e) He) as (r & Hr & Ie).
  destruct (O r Hr) as (e0 & w0 & I0 & W0 & F); [intros E; rewrite E in Ie; auto|].
  assert (S : forall e, In e (edges r) -> In e (all_edges p)) by (intros; apply in_all_edges; eauto).
  rewrite <- F. rewrite (odd_along_edge p q e w (fst e)); auto using on_edge_first.
  rewrite (odd_along_edge p q e0 w0 (fst e0)); auto using on_edge_first.
  destruct r as [|u r]; [destruct Ie|].
  rewrite !(odd_along_steps p q u (u :: r)); auto.
Qed.

(** Where the edge from u to v passes the height of z. *)
Definition passing (z : point) (e : point * point) : R :=
  fst (fst e) + (snd z - snd (fst e)) * ((fst (snd e) - fst (fst e)) / (snd (snd e) - snd (fst e))).

Lemma passing_on_edge z e : xorb (less (snd z) (snd (fst e))) (less (snd z) (snd (snd e))) = true ->
  on_edge (passing z e, snd z) (fst e) (snd e).
Proof.
  unfold passing. destruct z as [zx zy], e as [[ux uy] [vx vy]]; simpl. intros H.
  assert (D : vy - uy <> 0 /\ 0 <= (zy - uy) / (vy - uy) <= 1).
  { destruct (less_spec zy uy), (less_spec zy vy); try discriminate.
    - split; [lra|]. replace ((zy - uy) / (vy - uy)) with ((uy - zy) / (uy - vy)) by (field; lra).
      split; [apply Rmult_le_pos; [lra|]; left; apply Rinv_0_lt_compat; lra|].
      apply (Rmult_le_reg_r (uy - vy)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    - split; [lra|]. split; [apply Rmult_le_pos; [lra|]; left; apply Rinv_0_lt_compat; lra|].
      apply (Rmult_le_reg_r (vy - uy)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  exists ((zy - uy) / (vy - uy)). split; [tauto|]. simpl. f_equal; field; tauto.
Qed.

Definition crosses_edge (z : point) (e : point * point) : bool := crosses z (fst e) (snd e).

Lemma sum_app {A} (f : A -> bool) l m : sum f (l ++ m) = xorb (sum f l) (sum f m).
Proof. induction l; simpl; [destruct (sum f m); auto|]. rewrite IHl, xorb_assoc. reflexivity. Qed.
Lemma odd_all_edges z p : odd z p = sum (crosses_edge z) (all_edges p).
Proof. unfold odd, all_edges. induction p; simpl; auto. rewrite IHp, sum_app. reflexivity. Qed.

Lemma sum_true {A} (f : A -> bool) l : sum f l = true -> exists x, In x l /\ f x = true.
Proof.
  induction l; simpl; [discriminate|]. destruct (f a) eqn:E; eauto. intros H.
  destruct IHl as (x & I & F); [destruct (sum f l); auto|]. eauto.
Qed.

Lemma least {A} (f : A -> bool) (key : A -> R) l : sum f l = true ->
  exists x, In x l /\ f x = true /\ forall y, In y l -> f y = true -> key x <= key y.
Proof.
  intros H. apply sum_true in H. revert H. induction l as [|a l IH]; intros (x & I & F); [destruct I|].
  destruct (existsb f l) eqn:E.
  - apply existsb_exists in E. destruct (IH E) as (m & Im & Fm & M). destruct (f a) eqn:Fa.
    + destruct (Rle_dec (key a) (key m)).
      * exists a; repeat split; simpl; auto. intros y [<-|Iy] Fy; [lra|]. specialize (M y Iy Fy). lra.
      * exists m; repeat split; simpl; auto. intros y [<-|Iy] Fy; [lra|auto].
    + exists m; repeat split; simpl; auto. intros y [<-|Iy] Fy; [congruence|auto].
  - exists a. destruct I as [->|I].
    + repeat split; simpl; auto. intros y [<-|Iy] Fy; [lra|].
      assert (existsb f l = true) by (apply existsb_exists; eauto). congruence.
    + assert (existsb f l = true) by (apply existsb_exists; eauto). congruence.
Qed.

(** The first edge that the ray from a common point crosses, belonging to one part, has a point inside of the other one. *)
Lemma first_crossing p q z e : apart p q -> In e (all_edges p) -> crosses_edge z e = true ->
  (forall f, In f (all_edges q) -> crosses_edge z f = true -> passing z e <= passing z f) ->
  odd (passing z e, snd z) q = odd z q.
Proof.
  intros H He C M. rewrite !odd_all_edges. apply sum_ext. intros f Hf.
  unfold crosses_edge, crosses in *. fold (passing z e) in C. fold (passing z f).
  apply andb_prop in C. destruct C as [C1 C2]. apply less_true in C2. simpl.
  change (fst (fst f) + (snd z - snd (fst f)) * ((fst (snd f) - fst (fst f)) / (snd (snd f) - snd (fst f)))) with (passing z f).
  specialize (M f Hf). fold (passing z f) in M. destruct (xorb (less (snd z) (snd (fst f))) (less (snd z) (snd (snd f)))) eqn:X; auto. simpl.
  destruct (less_spec (passing z e) (passing z f)) as [L|L], (less_spec (fst z) (passing z f)) as [G|G]; auto; try lra.
  exfalso. assert (E : passing z e = passing z f).
  { apply Rle_antisym; [|lra]. apply M. apply andb_true_intro; split; auto. }
  destruct (H e f He Hf) as (n & H1 & H2 & H3 & H4).
  pose proof (passing_on_edge z e C1) as Oe. pose proof (passing_on_edge z f X) as Of. rewrite <- E in Of.
  pose proof (on_edge_after n _ _ _ _ Of H1 H2). pose proof (on_edge_after n _ _ _ _ Of H3 H4).
  pose proof (on_edge_before n _ _ _ _ Oe H0 H5). lra.
Qed.

Lemma not_on_both p q z : apart p q -> on_boundary z p -> on_boundary z q -> False.
Proof.
  intros H (r & e & Hr & He & Oe) (r' & f & Hr' & Hf & Of).
  destruct (H e f) as (n & H1 & H2 & H3 & H4); try (apply in_all_edges; eauto).
  pose proof (on_edge_after n _ _ _ _ Of H1 H2). pose proof (on_edge_after n _ _ _ _ Of H3 H4).
  pose proof (on_edge_before n _ _ _ _ Oe H0 H5). lra.
Qed.

Theorem parts_disjoint p q : apart p q -> rings_outside p q -> rings_outside q p ->
  forall z, ~ (in_part z p /\ in_part z q).
Proof.
  assert (B : forall p q z, apart p q -> rings_outside p q -> on_boundary z p -> in_part z q -> False).
  { intros p' q' z H O B [B'|I]; [eapply not_on_both; eauto|].
    destruct B as (r & e & Hr & He & Oe).
    rewrite (outside_everywhere p' q' H O e) in I; auto; [discriminate|]. apply in_all_edges; eauto. }
  intros H O O' z [[Bp|Ip] [Bq|Iq]].
  - apply (not_on_both p q z); auto.
  - apply (B p q z); auto. right; auto.
  - apply (B q p z); auto using apart_sym. right; auto.
  - pose proof Ip as Sp. pose proof Iq as Sq. rewrite odd_all_edges in Sp, Sq.
    destruct (least _ (passing z) _ Sp) as (e & He & Ce & Me). destruct (least _ (passing z) _ Sq) as (f & Hf & Cf & Mf).
    assert (On : forall e, crosses_edge z e = true -> on_edge (passing z e, snd z) (fst e) (snd e)).
    { intros g Cg. apply passing_on_edge. unfold crosses_edge, crosses in Cg. apply andb_prop in Cg. tauto. }
    destruct (Rle_dec (passing z e) (passing z f)).
    + assert (C : odd (passing z e, snd z) q = odd z q).
      { apply (first_crossing p); auto. intros g Hg Cg. specialize (Mf g Hg Cg). lra. }
      rewrite (outside_everywhere p q H O e) in C; auto. congruence.
    + assert (C : odd (passing z f, snd z) p = odd z p).
      { apply (first_crossing q); auto using apart_sym. intros g Hg Cg. specialize (Me g Hg Cg). lra. }
      rewrite (outside_everywhere q p (apart_sym p q H) O' f) in C; auto. congruence.
Qed.

(** Parts on different sides of a line. *)
Lemma rings_outside_across n x (p q : part) :
  (forall e, In e (all_edges p) -> dot n (fst e) < x) -> (forall e, In e (all_edges q) -> x < dot n (fst e) /\ x < dot n (snd e)) ->
  rings_outside p q.
Proof.
  intros Hp Hq r Hr Ne. destruct (edges r) as [|e l] eqn:E; [destruct Ne; auto|].
  assert (I : In e (edges r)) by (rewrite E; left; auto).
  exists e, (fst e). rewrite <- E. repeat split; auto using on_edge_first.
  specialize (Hp e ltac:(apply in_all_edges; eauto)).
  apply (odd_in_front n). intros r' f Hr' Hf. destruct (Hq f); [apply in_all_edges; eauto|]. lra.
Qed.
