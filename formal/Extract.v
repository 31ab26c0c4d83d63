(** The checker as an OCaml program, with integers of zarith: program/integer.ml says how. What is mapped here, and OCaml's
    own integers for lengths of lists, have to be trusted. *)

From Coq Require Import ZArith List Extraction ExtrOcamlBasic ExtrOcamlNatInt.
From Taut Require Import Definitions Numbers Models Functions Placement Outlines Whole Lines Check.

Extract Inductive BinNums.positive => "Integer.t"
  [ "Integer.double_plus_one" "Integer.double" "Integer.one" ]
  "(fun odd even one p -> if Integer.is_one p then one () else if Integer.is_odd p then odd (Integer.half p) else even (Integer.half p))".
Extract Inductive BinNums.Z => "Integer.t" [ "Integer.zero" "" "Integer.neg" ]
  "(fun zero positive negative z -> let s = Integer.sign z in if s = 0 then zero () else if s > 0 then positive z else negative (Integer.neg z))".

Extract Constant Z.add => "Integer.add".
Extract Constant Z.sub => "Integer.sub".
Extract Constant Z.mul => "Integer.mul".
Extract Constant Z.opp => "Integer.neg".
Extract Constant Z.abs => "Integer.abs".
Extract Constant Z.max => "Integer.max".
Extract Constant Z.eqb => "Integer.equal".
Extract Constant Z.leb => "Integer.leq".
Extract Constant Z.ltb => "Integer.lt".
Extract Constant Z.eq_dec => "Integer.equal".
Extract Constant Z.odd => "Integer.is_odd".
Extract Constant Z.to_nat => "Integer.to_nat".
Extract Constant Z.log2 => "Integer.log2".
Extract Constant Z.sqrt => "Integer.sqrt".
Extract Constant Z.div => "Integer.div".
Extract Constant Z.shiftl => "Integer.shiftl".
Extract Constant Z.shiftr => "Integer.shiftr".

Extraction "taut_check.ml" check.
