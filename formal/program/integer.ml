(* Integers for the extracted checker: Coq's operations on Z, in terms of zarith. This file has to be trusted. *)
type t = Z.t

let zero = Z.zero
let one = Z.one
let is_one z = Z.equal z Z.one
let is_odd = Z.is_odd
let sign = Z.sign
let neg = Z.neg
let double z = Z.shift_left z 1
let double_plus_one z = Z.succ (Z.shift_left z 1)
let half z = Z.shift_right z 1
let add = Z.add
let sub = Z.sub
let mul = Z.mul
let abs = Z.abs
let max = Z.max
let equal = Z.equal
let leq = Z.leq
let lt = Z.lt
let to_nat z = if Z.sign z <= 0 then 0 else Z.to_int z

(* The next three are 0 in Coq where they have no value. *)
let log2 z = if Z.sign z <= 0 then Z.zero else Z.of_int (Z.numbits z - 1)
let sqrt z = if Z.sign z <= 0 then Z.zero else Z.sqrt z
let div a b = if Z.sign b = 0 then Z.zero else Z.fdiv a b

(* Rounded down, and the other way where the second argument is negative. *)
let shift z n = if n >= 0 then Z.shift_left z n else Z.shift_right z (-n)
let shiftl z n = shift z (Z.to_int n)
let shiftr z n = shift z (-Z.to_int n)
