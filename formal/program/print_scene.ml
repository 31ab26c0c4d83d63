(* A scene as it was read, in the format taut-scene/1 with motions as polynomials, for comparison with other readers. *)
open Taut_check

let number a = Printf.sprintf "%.17g" (Numbers.to_float a)
let list f l = "[" ^ String.concat "," (List.map f l) ^ "]"
let numbers = list number
let point (x, y) = numbers [ x; y ]

let rotation = function
  | Fixed -> "null"
  | Angle a -> "{\"angle\":" ^ numbers a ^ "}"
  | HalfAngleTangent s -> "{\"half_angle_tangent\":" ^ numbers s ^ "}"
  | Cosine a -> "{\"cosine\":" ^ numbers a ^ "}"
  | Direction (a, b) -> "{\"direction\":{\"a\":" ^ numbers a ^ ",\"b\":" ^ numbers b ^ "}}"

let piece last p =
  let orbit = match p.orbit with
    | None -> ""
    | Some (centre, a) -> Printf.sprintf ",\"orbit\":{\"center\":%s,\"angle\":%s}" (point centre) (numbers a) in
  let until = if last then "" else ",\"until\":" ^ number p.until in
  Printf.sprintf "{\"x\":%s,\"y\":%s,\"rotation\":%s,\"origin\":%s,\"pivot\":%s%s%s}" (numbers (fst p.shift)) (numbers (snd p.shift))
    (rotation p.turn) (number p.origin) (point p.pivot) orbit until

let motion m = list Fun.id (List.mapi (fun i p -> piece (i + 1 = List.length m) p) m)

let text scene names =
  let body i b = Printf.sprintf "{\"name\":%S,\"chain\":%s,\"parts\":%s}" names.(i) (list motion b.chain) (list (list (list point)) b.shape) in
  Printf.sprintf "{\"time\":%s,\n\"bodies\":%s,\n\"ignored\":%s,\n\"at_rest\":%b}" (numbers [ scene.start; scene.stop ])
    ("[" ^ String.concat ",\n" (List.mapi body scene.bodies) ^ "]")
    (list (fun (i, j) -> Printf.sprintf "[%d,%d]" i j) scene.ignored) scene.at_rest
