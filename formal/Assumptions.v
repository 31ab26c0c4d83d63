(** What the theorem rests on: printed, and compared by the Makefile with the axioms of Coq's real numbers. *)

From Taut Require Import Soundness.
Print Assumptions accepted_is_free.
