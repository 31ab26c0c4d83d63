(* A reader of JSON: values as they are written, numbers as the doubles nearest to them. *)
type t =
  | Null
  | Bool of bool
  | Number of float
  | String of string
  | List of t list
  | Object of (string * t) list

exception Error of string

let max_nesting = 32

let parse text =
  let n = String.length text and at = ref 0 in
  let fail what = raise (Error (Printf.sprintf "byte %d: %s" !at what)) in
  let peek () = if !at < n then text.[!at] else '\000' in
  let rec skip_space () =
    match peek () with
    | ' ' | '\t' | '\n' | '\r' when !at < n -> incr at; skip_space ()
    | _ -> () in
  let expect c = if !at < n && text.[!at] = c then incr at else fail (Printf.sprintf "expected '%c'" c) in
  let word w v =
    let l = String.length w in
    if !at + l <= n && String.sub text !at l = w then (at := !at + l; v) else fail "unknown word" in
  let digits () =
    let first = !at in
    while (match peek () with '0' .. '9' -> true | _ -> false) do incr at done;
    if !at = first then fail "expected a digit" in
  let number () =
    let first = !at in
    if peek () = '-' then incr at;
    if peek () = '0' then incr at else digits ();
    if peek () = '.' then (incr at; digits ());
    (match peek () with
     | 'e' | 'E' -> incr at; (match peek () with '+' | '-' -> incr at | _ -> ()); digits ()
     | _ -> ());
    let x = float_of_string (String.sub text first (!at - first)) in
    if Float.is_integer x || Float.abs x < infinity then x else fail "a number is too large for a double" in
  let utf8 b code =
    if not (Uchar.is_valid code) then fail "no character" else Buffer.add_utf_8_uchar b (Uchar.of_int code) in
  let hex4 () =
    if !at + 4 > n then fail "expected four digits";
    let s = String.sub text !at 4 in
    if not (String.for_all (function '0' .. '9' | 'a' .. 'f' | 'A' .. 'F' -> true | _ -> false) s) then fail "expected four digits";
    at := !at + 4; int_of_string ("0x" ^ s) in
  let escape b =
    let c = peek () in
    incr at;
    match c with
    | '"' | '\\' | '/' -> Buffer.add_char b c
    | 'b' -> Buffer.add_char b '\b'
    | 'f' -> Buffer.add_char b '\012'
    | 'n' -> Buffer.add_char b '\n'
    | 'r' -> Buffer.add_char b '\r'
    | 't' -> Buffer.add_char b '\t'
    | 'u' ->
        let high = hex4 () in
        if high >= 0xD800 && high < 0xDC00 then begin
          expect '\\'; expect 'u';
          let low = hex4 () in
          if low < 0xDC00 || low > 0xDFFF then fail "no character";
          utf8 b (0x10000 + ((high - 0xD800) lsl 10) + (low - 0xDC00))
        end else utf8 b high
    | _ -> fail "unknown escape" in
  let string () =
    expect '"';
    let b = Buffer.create 16 in
    let rec go () =
      if !at >= n then fail "a string does not end";
      match text.[!at] with
      | '"' -> incr at
      | '\\' -> incr at; escape b; go ()
      | c when c < ' ' -> fail "a control character in a string"
      | c -> incr at; Buffer.add_char b c; go () in
    go (); Buffer.contents b in
  (* Elements up to the closing character, each read by [element]. *)
  let sequence last element =
    incr at; skip_space ();
    if !at < n && text.[!at] = last then (incr at; [])
    else
      let rec go read =
        let read = element () :: read in
        skip_space ();
        if peek () = ',' then (incr at; skip_space (); go read) else (expect last; List.rev read) in
      go [] in
  let rec value depth =
    if depth > max_nesting then fail "nested too deep";
    skip_space ();
    if !at >= n then fail "the text ends too early";
    match text.[!at] with
    | '{' ->
        let members = sequence '}' (fun () ->
          let key = string () in
          skip_space (); expect ':';
          (key, value (depth + 1))) in
        let keys = List.sort compare (List.map fst members) in
        let rec twice = function a :: (b :: _ as rest) -> if a = b then Some a else twice rest | _ -> None in
        (match twice keys with Some k -> fail ("the key \"" ^ k ^ "\" twice") | None -> Object members)
    | '[' -> List (sequence ']' (fun () -> value (depth + 1)))
    | '"' -> String (string ())
    | 't' -> word "true" (Bool true)
    | 'f' -> word "false" (Bool false)
    | 'n' -> word "null" Null
    | _ -> Number (number ()) in
  let v = value 0 in
  skip_space ();
  if !at < n then fail "text after the end" else v

let error where what = raise (Error (where ^ ": " ^ what))

(* The members of an object that has no keys but these. *)
let members where keys = function
  | Object m ->
      List.iter (fun (k, _) -> if not (List.mem k keys) then error where ("unknown key \"" ^ k ^ "\"")) m; m
  | _ -> error where "expected an object"
let find m key = List.assoc_opt key m
let get where m key = match find m key with Some v -> v | None -> error where ("the key \"" ^ key ^ "\" is missing")
let list where = function List l -> l | _ -> error where "expected a list"
let string where = function String s -> s | _ -> error where "expected a string"
let float where = function Number x -> x | _ -> error where "expected a number"
let pair where = function List [ a; b ] -> (a, b) | _ -> error where "expected a list of two"
