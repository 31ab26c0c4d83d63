(** Parity of crossings: it does not change along a path that keeps clear of the boundary, nor in a turned view, and so two
    parts are disjoint if their boundaries are apart and each ring has a point that is outside of the other part. There is
    no analysis here: a direction that separates two edges says how their crossings change, and around a ring the changes
    cancel each other. *)

From Coq Require Import Reals ZArith List Bool Lra Psatz.
From Taut Require Import Definitions.
Import ListNotations.
Open Scope R_scope.

Definition dot (n p : point) : R := fst n * fst p + snd n * snd p.
Definition between (k : R) (u v : point) : point := (fst u + k * (fst v - fst u), snd u + k * (snd v - snd u)).

Lemma less_true a b : less a b = true <-> a < b.
Proof. unfold less; destruct (Rlt_dec a b); split; auto; discriminate. Qed.
Lemma less_false a b : less a b = false <-> b <= a.
Proof. unfold less; destruct (Rlt_dec a b); split; try discriminate; try lra; auto. Qed.
Lemma less_spec a b : reflect (a < b) (less a b).
Proof. unfold less; destruct (Rlt_dec a b); constructor; auto. Qed.

(** * One edge *)

Lemma same_sign a b c : 0 < a * (b * c) -> 0 < b -> (0 < c <-> 0 < a).
Proof.
  intros H B. split; intros.
  - destruct (Rlt_dec 0 a); auto. exfalso. assert (0 < b * c) by (apply Rmult_lt_0_compat; auto). nra.
  - destruct (Rlt_dec 0 c); auto. exfalso. assert (b * c <= 0) by nra. nra.
Qed.

(** In a half plane in front of z, whose normal is n, the ray crosses wherever an edge passes its line, or nowhere. *)
Lemma crosses_in_front n z u v : dot n z < dot n u -> dot n z < dot n v ->
  crosses z u v = less 0 (fst n) && xorb (less (snd z) (snd u)) (less (snd z) (snd v)).
Proof.
  unfold crosses, dot; destruct n as [nx ny], z as [zx zy], u as [ux uy], v as [vx vy]; simpl; intros Hu Hv.
  destruct (less_spec zy uy) as [Au|Au], (less_spec zy vy) as [Av|Av]; simpl; rewrite ?andb_false_r; auto; rewrite andb_true_r.
  - assert (D : vy - uy < 0) by lra. set (k := (vx - ux) / (vy - uy)).
    assert (K : vx = ux + k * (vy - uy)) by (unfold k; field; lra).
    assert (E : (uy - zy) * (nx * (vx - zx) + ny * (vy - zy)) + (zy - vy) * (nx * (ux - zx) + ny * (uy - zy)) =
                nx * ((uy - vy) * (ux + (zy - uy) * k - zx))) by (rewrite K; ring).
    assert (P : 0 < nx * ((uy - vy) * (ux + (zy - uy) * k - zx))) by (rewrite <- E; nra).
    pose proof (same_sign _ _ _ P ltac:(lra)) as S.
    destruct (less_spec zx (ux + (zy - uy) * k)), (less_spec 0 nx); auto; exfalso; destruct S; lra.
  - assert (D : vy - uy > 0) by lra. set (k := (vx - ux) / (vy - uy)).
    assert (K : vx = ux + k * (vy - uy)) by (unfold k; field; lra).
    assert (E : (vy - zy) * (nx * (ux - zx) + ny * (uy - zy)) + (zy - uy) * (nx * (vx - zx) + ny * (vy - zy)) =
                nx * ((vy - uy) * (ux + (zy - uy) * k - zx))) by (rewrite K; ring).
    assert (P : 0 < nx * ((vy - uy) * (ux + (zy - uy) * k - zx))) by (rewrite <- E; nra).
    pose proof (same_sign _ _ _ P ltac:(lra)) as S.
    destruct (less_spec zx (ux + (zy - uy) * k)), (less_spec 0 nx); auto; exfalso; destruct S; lra.
Qed.

(** Crossings see only differences. *)
Lemma crosses_relative z u v : crosses z u v = crosses (0, 0) (minus u z) (minus v z).
Proof.
  unfold crosses, minus; destruct z as [zx zy], u as [ux uy], v as [vx vy]; simpl.
  assert (L : forall a b, less a b = less 0 (b - a))
    by (intros a b; destruct (less_spec a b), (less_spec 0 (b - a)); auto; lra).
  rewrite (L zy uy), (L zy vy). f_equal. rewrite (L zx), (L 0 (_ + _)). f_equal.
  replace (vy - zy - (uy - zy)) with (vy - uy) by ring. replace (vx - zx - (ux - zx)) with (vx - ux) by ring. ring.
Qed.

Lemma dot_minus n p q : dot n (minus p q) = dot n p - dot n q.
Proof. unfold dot, minus; simpl; ring. Qed.

Lemma minus_self p : minus p p = (0, 0).
Proof. unfold minus; f_equal; ring. Qed.

(** The crossing of the way of a vertex, seen from the way of a point. *)
Definition passes (z z' u u' : point) : bool := crosses (0, 0) (minus u z) (minus u' z').

Lemma in_front_relative n z u v z' : dot n z < dot n u -> dot n z' < dot n v ->
  crosses (0, 0) (minus u z) (minus v z') =
  less 0 (fst n) && xorb (less 0 (snd (minus u z))) (less 0 (snd (minus v z'))).
Proof.
  intros Hu Hv. apply (crosses_in_front n (0, 0)).
  - rewrite dot_minus. unfold dot at 1; simpl; lra.
  - rewrite dot_minus. unfold dot at 1; simpl; lra.
Qed.

(** A point moves from z to z', and an edge from u v to u' v': if one direction separates both, before and after. *)
Lemma edge_step n z u v z' u' v' :
  dot n z < dot n u -> dot n z < dot n v -> dot n z' < dot n u' -> dot n z' < dot n v' ->
  xorb (crosses z u v) (crosses z' u' v') = xorb (passes z z' u u') (passes z z' v v').
Proof.
  intros H1 H2 H3 H4. rewrite (crosses_relative z), (crosses_relative z'). unfold passes.
  rewrite !(in_front_relative n) by assumption.
  destruct (less 0 (fst n)), (less 0 (snd (minus u z))), (less 0 (snd (minus v z))), (less 0 (snd (minus u' z'))),
    (less 0 (snd (minus v' z'))); reflexivity.
Qed.

(** * Around a ring *)

Lemma steps_map {A B} (f : A -> B) first r : steps (f first) (map f r) = map (fun e => (f (fst e), f (snd e))) (steps first r).
Proof.
  induction r as [|u [|v r] IH]; simpl; auto. simpl in IH. rewrite IH. reflexivity.
Qed.
Lemma edges_map {A B} (f : A -> B) r : edges (map f r) = map (fun e => (f (fst e), f (snd e))) (edges r).
Proof. destruct r; simpl; auto. apply (steps_map f a (a :: r)). Qed.

Definition sum {A} (f : A -> bool) (l : list A) : bool := fold_right (fun x odd => xorb (f x) odd) false l.

Lemma sum_xorb {A} (f g : A -> bool) l : sum (fun x => xorb (f x) (g x)) l = xorb (sum f l) (sum g l).
Proof. induction l; simpl; auto. rewrite IHl. destruct (f a), (g a), (sum f l), (sum g l); auto. Qed.
Lemma sum_ext {A} (f g : A -> bool) l : (forall x, In x l -> f x = g x) -> sum f l = sum g l.
Proof. induction l; simpl; auto. intros H. rewrite H, IHl; auto. Qed.
Lemma sum_map {A B} (m : A -> B) (f : B -> bool) l : sum f (map m l) = sum (fun x => f (m x)) l.
Proof. induction l; simpl; auto. rewrite IHl; auto. Qed.

(** What changes at both ends of each edge changes nothing around a ring. *)
Lemma steps_cancel {A} (w : A -> bool) first r :
  sum (fun e => xorb (w (fst e)) (w (snd e))) (steps first r) = match r with [] => false | u :: _ => xorb (w u) (w first) end.
Proof.
  induction r as [|u r IH]; auto. simpl. destruct r as [|v r]; simpl.
  - destruct (w u), (w first); auto.
  - simpl in IH. rewrite IH. destruct (w u), (w v), (w first); auto.
Qed.
Lemma ring_cancel {A} (w : A -> bool) (r : list A) : sum (fun e => xorb (w (fst e)) (w (snd e))) (edges r) = false.
Proof. destruct r; auto. unfold edges. rewrite steps_cancel. apply xorb_nilpotent. Qed.

Lemma odd_ring_sum z r : odd_ring z r = sum (fun e => crosses z (fst e) (snd e)) (edges r).
Proof. reflexivity. Qed.

(** Two rings with the same names of vertices, in two places, and a point in two places: the same parity if each edge is
    separated from the point by one direction in both. *)
Lemma ring_step {A} (f g : A -> point) z z' (r : list A) :
  (forall e, In e (edges r) -> exists n, dot n z < dot n (f (fst e)) /\ dot n z < dot n (f (snd e)) /\
                                          dot n z' < dot n (g (fst e)) /\ dot n z' < dot n (g (snd e))) ->
  odd_ring z (map f r) = odd_ring z' (map g r).
Proof.
  intros H. rewrite !odd_ring_sum, !edges_map, !sum_map. apply xorb_eq. rewrite <- sum_xorb. simpl.
  rewrite (sum_ext _ (fun e => xorb (passes z z' (f (fst e)) (g (fst e))) (passes z z' (f (snd e)) (g (snd e))))).
  - apply (ring_cancel (fun a => passes z z' (f a) (g a))).
  - intros e He. destruct (H e He) as (n & H1 & H2 & H3 & H4). apply (edge_step n); auto.
Qed.

Lemma odd_step {A} (f g : A -> point) z z' (p : list (list A)) :
  (forall r e, In r p -> In e (edges r) ->
     exists n, dot n z < dot n (f (fst e)) /\ dot n z < dot n (f (snd e)) /\
               dot n z' < dot n (g (fst e)) /\ dot n z' < dot n (g (snd e))) ->
  odd z (map (map f) p) = odd z' (map (map g) p).
Proof.
  intros H. unfold odd. induction p as [|r p IH]; simpl; auto. rewrite IH.
  - f_equal. apply ring_step. intros e He. apply (H r e); simpl; auto.
  - intros r' e Hr He. apply (H r' e); simpl; auto.
Qed.

(** A part on one side of a line through a point does not contain it. *)
Lemma odd_in_front n z (p : part) :
  (forall r e, In r p -> In e (edges r) -> dot n z < dot n (fst e) /\ dot n z < dot n (snd e)) -> odd z p = false.
Proof.
  intros H. unfold odd. induction p as [|r p IH]; simpl; auto. rewrite IH.
  - rewrite xorb_false_r, odd_ring_sum.
    rewrite (sum_ext _ (fun e : point * point => xorb (less 0 (fst n) && less (snd z) (snd (fst e))) (less 0 (fst n) && less (snd z) (snd (snd e))))).
    + apply (ring_cancel (fun u => less 0 (fst n) && less (snd z) (snd u))).
    + intros e He. destruct (H r e) as [H1 H2]; simpl; auto. rewrite (crosses_in_front n) by assumption.
      destruct (less 0 (fst n)); auto.
  - intros r' e Hr He. apply (H r' e); simpl; auto.
Qed.

(** * Turned views *)

(** The image of a point under a rotation, with a scale, and a translation. *)
Record frame := Frame { at_ : point; along : point }.
Definition apply (m : frame) (p : point) : point := plus (at_ m) (turned (along m) p).
Definition proper (m : frame) : Prop := 0 < fst (along m) * fst (along m) + snd (along m) * snd (along m).

(** Two points that do not have the origin between them lie in front of it. *)
Lemma separating_normal u v :
  (exists k, 0 <= k <= 1 /\ between k u v = (0, 0)) \/ exists n, 0 < dot n u /\ 0 < dot n v.
Proof.
  destruct u as [ux uy], v as [vx vy]. unfold between, dot; simpl.
  destruct (Rtotal_order (ux * vy - uy * vx) 0) as [C|[C|C]].
  - right. exists (uy - vy, vx - ux); simpl; split; nra.
  - destruct (Rlt_dec 0 (ux * vx + uy * vy)) as [D|D].
    + right. exists (ux, uy); simpl; split; [|lra].
      destruct (Req_dec ux 0); [|nra]. destruct (Req_dec uy 0); [subst; lra|nra].
    + left. destruct (Req_dec (ux * ux + uy * uy) 0) as [Z|Z].
      * exists 0. split; [lra|]. assert (ux = 0) by nra. assert (uy = 0) by nra. subst. f_equal; ring.
      * set (a := ux * ux + uy * uy) in *. set (b := ux * vx + uy * vy) in *. assert (0 < a) by (unfold a in *; nra).
        exists (a / (a - b)). assert (Q : 0 < a - b) by lra. split.
        { split; [apply Rmult_le_pos; [lra|]; left; apply Rinv_0_lt_compat; auto|].
          apply (Rmult_le_reg_r (a - b)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
        f_equal; apply (Rmult_eq_reg_r (a - b)); try lra.
        { replace ((ux + a / (a - b) * (vx - ux)) * (a - b)) with (a * vx - b * ux) by (field; lra).
          replace (a * vx - b * ux) with (- uy * (ux * vy - uy * vx)) by (unfold a, b; ring). rewrite C; ring. }
        { replace ((uy + a / (a - b) * (vy - uy)) * (a - b)) with (a * vy - b * uy) by (field; lra).
          replace (a * vy - b * uy) with (ux * (ux * vy - uy * vx)) by (unfold a, b; ring). rewrite C; ring. }
  - right. exists (vy - uy, ux - vx); simpl; split; nra.
Qed.

(** Crossings of a ray in direction d, in a half plane with normal n, of an edge at u and v as seen from the ray's start. *)
Definition left (d u : point) : bool := less 0 (fst d * snd u - snd d * fst u).
Definition ray (d n u v : point) : bool := less 0 (dot n d) && xorb (left d u) (left d v).
(** The wedge from direction d to direction e. *)
Definition wedge (d e u : point) : bool := left d u && negb (left e u).

Lemma wedge_step d e n u v : 0 < fst d * snd e - snd d * fst e -> 0 < dot n u -> 0 < dot n v ->
  xorb (ray d n u v) (ray e n u v) = xorb (wedge d e u) (wedge d e v).
Proof.
  intros W.
  assert (S : forall p, 0 < dot n p ->
    xorb (less 0 (dot n d) && left d p) (less 0 (dot n e) && left e p) =
    xorb (wedge d e p) (negb (less 0 (dot n d)) && less 0 (dot n e))).
  { intros p Hp. unfold wedge, left.
    set (w := fst d * snd e - snd d * fst e) in *.
    set (a := fst e * snd p - snd e * fst p). set (b := fst d * snd p - snd d * fst p).
    assert (E : w * dot n p = b * dot n e - a * dot n d) by (unfold w, a, b, dot; ring).
    assert (P : 0 < b * dot n e - a * dot n d) by (rewrite <- E; apply Rmult_lt_0_compat; auto).
    destruct (less_spec 0 (dot n d)), (less_spec 0 (dot n e)), (less_spec 0 a), (less_spec 0 b); simpl; auto; exfalso; nra. }
  intros Hu Hv. generalize (S u Hu) (S v Hv). unfold ray.
  destruct (less 0 (dot n d)), (less 0 (dot n e)), (left d u), (left d v), (left e u), (left e v), (wedge d e u), (wedge d e v);
    simpl; auto; discriminate.
Qed.

(** From any direction to any other one: a change at both ends of the edge that depends on the directions only. *)
Lemma view_step d e : 0 < dot d d -> 0 < dot e e ->
  exists w : point -> bool, forall n u v, 0 < dot n u -> 0 < dot n v ->
    xorb (ray d n u v) (ray e n u v) = xorb (w u) (w v).
Proof.
  assert (B : forall d e, fst d * snd e - snd d * fst e <> 0 ->
    exists w : point -> bool, forall n u v, 0 < dot n u -> 0 < dot n v -> xorb (ray d n u v) (ray e n u v) = xorb (w u) (w v)).
  { intros d' e' H. destruct (Rdichotomy _ _ H) as [L|G].
    - exists (wedge e' d'). intros n u v Hu Hv. rewrite xorb_comm. apply wedge_step; auto; lra.
    - exists (wedge d' e'). intros n u v Hu Hv. apply wedge_step; auto. }
  intros Hd He. destruct (Req_dec (fst d * snd e - snd d * fst e) 0) as [C|C]; [|apply B; auto].
  set (m := (- snd d, fst d) : point).
  destruct (B d m) as [w1 H1]; [unfold m, dot in *; simpl in *; lra|].
  destruct (B m e) as [w2 H2].
  { unfold m, dot in *; simpl in *. intros Z. assert (Y : fst d * fst e + snd d * snd e = 0) by lra.
    assert (X : 0 < (fst d * fst d + snd d * snd d) * (fst e * fst e + snd e * snd e)) by nra.
    assert (L : (fst d * fst d + snd d * snd d) * (fst e * fst e + snd e * snd e) =
            (fst d * snd e - snd d * fst e) * (fst d * snd e - snd d * fst e) +
            (fst d * fst e + snd d * snd e) * (fst d * fst e + snd d * snd e)) by ring.
    rewrite C, Y in L. lra. }
  exists (fun u => xorb (w1 u) (w2 u)). intros n u v Hu Hv. generalize (H1 n u v Hu Hv) (H2 n u v Hu Hv).
  destruct (ray d n u v), (ray m n u v), (ray e n u v), (w1 u), (w1 v), (w2 u), (w2 v); simpl; auto; discriminate.
Qed.

Lemma crosses_ray n z u v : dot n z < dot n u -> dot n z < dot n v -> crosses z u v = ray (1, 0) n (minus u z) (minus v z).
Proof.
  intros Hu Hv. rewrite (crosses_in_front n) by assumption. unfold ray, left, dot, minus; simpl.
  f_equal; [|f_equal]; match goal with |- less ?a ?b = less ?c ?d => destruct (less_spec a b), (less_spec c d); auto; lra end.
Qed.

(** The ray to the right in the turned view is a ray in the direction (c, -s) before. *)
Lemma crosses_turned m n z u v : proper m -> dot n z < dot n u -> dot n z < dot n v ->
  crosses (apply m z) (apply m u) (apply m v) = ray (fst (along m), - snd (along m)) n (minus u z) (minus v z).
Proof.
  unfold proper. destruct m as [[ox oy] [c s]], n as [nx ny], z as [zx zy], u as [ux uy], v as [vx vy].
  unfold dot; simpl. intros P Hu Hv.
  rewrite (crosses_in_front (c * nx - s * ny, s * nx + c * ny)); unfold dot, apply, plus, turned; simpl; [|nra|nra].
  unfold ray, left, dot, minus; simpl.
  f_equal; [|f_equal]; match goal with |- less ?a ?b = less ?c ?d => destruct (less_spec a b), (less_spec c d); auto; lra end.
Qed.

Definition off_edge (z u v : point) : Prop := exists n, dot n z < dot n u /\ dot n z < dot n v.

Lemma on_or_off_edge z u v : on_edge z u v \/ off_edge z u v.
Proof.
  destruct (separating_normal (minus u z) (minus v z)) as [(k & Hk & E)|(n & H1 & H2)].
  - left. exists k. split; auto. unfold between, minus in E; simpl in E. injection E; intros E2 E1.
    destruct z as [zx zy]; simpl in *. f_equal; lra.
  - right. rewrite dot_minus in H1, H2. exists n; lra.
Qed.

Lemma on_or_off z (p : part) : on_boundary z p \/ forall r e, In r p -> In e (edges r) -> off_edge z (fst e) (snd e).
Proof.
  assert (L : forall l : list (point * point), (exists e, In e l /\ on_edge z (fst e) (snd e)) \/
                                               forall e, In e l -> off_edge z (fst e) (snd e)).
  { induction l as [|e l [(e' & I & O)|IH]]; [right; intros e []|left; exists e'; simpl; auto|].
    destruct (on_or_off_edge z (fst e) (snd e)); [left; exists e; simpl; auto|].
    right. intros e' [<-|I]; auto. }
  induction p as [|r p [(r' & e & I & J & O)|IH]]; [right; intros r e []|left; exists r', e; simpl; auto|].
  destruct (L (edges r)) as [(e & I & O)|H]; [left; exists r, e; simpl; auto|].
  right. intros r' e [<-|I]; eauto.
Qed.

Lemma odd_turned m z p : proper m -> (forall r e, In r p -> In e (edges r) -> off_edge z (fst e) (snd e)) ->
  odd (apply m z) (map (map (apply m)) p) = odd z p.
Proof.
  intros P. assert (D : 0 < dot (fst (along m), - snd (along m)) (fst (along m), - snd (along m)))
    by (unfold proper, dot in *; simpl in *; lra).
  destruct (view_step (1, 0) _ ltac:(unfold dot; simpl; lra) D) as [w W].
  intros H. unfold odd. induction p as [|r p IH]; simpl; auto. rewrite IH.
  - f_equal. rewrite !odd_ring_sum, edges_map, sum_map. symmetry. apply xorb_eq. rewrite <- sum_xorb. simpl.
    rewrite (sum_ext _ (fun e => xorb (w (minus (fst e) z)) (w (minus (snd e) z)))).
    + apply (ring_cancel (fun u => w (minus u z))).
    + intros e He. destruct (H r e) as (n & H1 & H2); simpl; auto.
      rewrite (crosses_turned m n) by assumption. rewrite (crosses_ray n) by assumption.
      apply W; rewrite dot_minus; lra.
  - intros r' e Hr He. apply (H r' e); simpl; auto.
Qed.

Lemma apply_between m k u v : apply m (between k u v) = between k (apply m u) (apply m v).
Proof. unfold apply, between, plus, turned; simpl. f_equal; ring. Qed.

Lemma on_boundary_turned m z p : on_boundary z p -> on_boundary (apply m z) (map (map (apply m)) p).
Proof.
  intros (r & e & Hr & He & k & Hk & E). exists (map (apply m) r), (apply m (fst e), apply m (snd e)). repeat split.
  - apply in_map; auto.
  - rewrite edges_map. apply (in_map (fun e => (apply m (fst e), apply m (snd e)))); auto.
  - exists k. split; auto. rewrite E. apply apply_between.
Qed.

Lemma in_part_turned m z p : proper m -> in_part z p -> in_part (apply m z) (map (map (apply m)) p).
Proof.
  intros P [B|O]; [left; apply on_boundary_turned; auto|].
  destruct (on_or_off z p) as [B|H]; [left; apply on_boundary_turned; auto|].
  right. rewrite odd_turned; auto.
Qed.
