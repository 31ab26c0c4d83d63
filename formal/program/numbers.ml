(* Doubles as numbers m * 2^e, and the rounding of exact numbers to doubles that keyframes, spins and sweeps need. *)
open Taut_check
open Exact

let number m e =
  if Z.equal m Z.zero then { mantissa = Z.zero; exponent = Z.zero }
  else
    let k = Z.trailing_zeros m in
    { mantissa = Z.shift_right m k; exponent = Z.of_int (e + k) }

let of_float x =
  let m, e = Float.frexp x in
  number (Z.of_float (Float.ldexp m 53)) (e - 53)

let of_int k = number (Z.of_int k) 0
let zero = of_int 0

let to_rational a =
  let e = Z.to_int a.exponent in
  if e >= 0 then Q.of_bigint (Z.shift_left a.mantissa e) else Q.make a.mantissa (Z.shift_left Z.one (-e))

let to_float a = Float.ldexp (Z.to_float a.mantissa) (Z.to_int a.exponent)

(* The double nearest to q; of two, the one whose last bit is 0. *)
let nearest_double q =
  let n = Z.abs (Q.num q) and d = Q.den q in
  if Z.equal n Z.zero then zero
  else
    (* n / d is between 2^(e - 1) and 2^(e + 1); 53 bits, or what doubles have below 2^-1022 *)
    let scaled e = if e <= 0 then Z.div_rem (Z.shift_left n (-e)) d, d else Z.div_rem n (Z.shift_left d e), Z.shift_left d e in
    let guess = Stdlib.max (Z.numbits n - Z.numbits d - 53) (-1074) in
    let e = if Z.numbits (fst (fst (scaled guess))) > 53 then guess + 1 else guess in
    let (m, rest), den = scaled e in
    let twice = Z.compare (Z.shift_left rest 1) den in
    let m = if twice > 0 || (twice = 0 && Z.is_odd m) then Z.succ m else m in
    number (if Q.sign q < 0 then Z.neg m else m) e

(* Pi, within 2^-1100, by Machin's formula. *)
let pi =
  let bits = 1120 in
  let arctan_inverse k =
    let k2 = k * k in
    let rec sum power i sign total =
      if Z.equal power Z.zero then total
      else
        let term = Z.div power (Z.of_int i) in
        sum (Z.div power (Z.of_int k2)) (i + 2) (-sign) (if sign > 0 then Z.add total term else Z.sub total term) in
    sum (Z.div (Z.shift_left Z.one bits) (Z.of_int k)) 1 1 Z.zero in
  let quarter = Z.sub (Z.shift_left (arctan_inverse 5) 2) (arctan_inverse 239) in
  Q.make (Z.shift_left quarter 2) (Z.shift_left Z.one bits)
let radians_per_degree = Q.div pi (Q.of_int 180)

(* Cosine and sine of an angle in radians, |a| < 7, within 2^-1000, by their series. *)
let cos_sin a =
  let bits = 1100 in
  let x = Z.div (Z.shift_left (Q.num a) bits) (Q.den a) in
  let product a b = Z.shift_right (Z.mul a b) bits in
  let square = product x x in
  let rec sum term k total =
    if Z.leq (Z.abs term) Z.one then total
    else sum (Z.neg (Z.div (product term square) (Z.of_int ((k + 1) * (k + 2))))) (k + 2) (Z.add total term) in
  let one = Z.shift_left Z.one bits in
  (Q.make (sum one 0 Z.zero) one, Q.make (sum x 1 Z.zero) one)
