(* taut-verified SCENE LOG: does the log prove that the scene's bodies are disjoint? Exit code 0 if it does, 1 if it does not,
   2 for errors, 3 for scenes that are not covered. *)
open Taut_check

let read file =
  let channel = open_in_bin file in
  Fun.protect ~finally:(fun () -> close_in channel) (fun () -> really_input_string channel (in_channel_length channel))

let verify scene_file log_file =
  let scene, names = Scene_reader.read (read scene_file) in
  let log = Log_reader.read (read log_file) in
  (* Where nothing is tested, or at no instant, the theorem says nothing. *)
  let empty = log.pairs = [] || Q.lt (Numbers.to_rational log.proved_until) (Numbers.to_rational scene.start) in
  if empty then (print_endline "NOT PROVED: no pair is tested, or at no instant"; 1)
  else if not (check scene log) then (print_endline "NOT PROVED"; 1)
  else begin
    let from = Numbers.to_float scene.start and until = Numbers.to_float log.proved_until in
    let whole = Q.leq (Numbers.to_rational scene.stop) (Numbers.to_rational log.proved_until) in
    Printf.printf "VERIFIED  %s on [%.17g, %.17g]%s\n  %d bodies, %d pairs tested, %d windows\n"
      (if whole then "free" else "free until a time:") from until
      (if whole then "" else Printf.sprintf " of [%.17g, %.17g]" from (Numbers.to_float scene.stop))
      (Array.length names) (List.length log.pairs)
      (List.fold_left (fun n (_, windows) -> n + List.length windows) 0 log.pairs);
    0
  end

let usage = "usage: taut-verified SCENE LOG        check a log of `taut prove --exact`\n\
            \       taut-verified --print SCENE    print the scene as it was read\n"

let run = function
  | [ "--print"; scene ] ->
      let scene, names = Scene_reader.read (read scene) in
      print_endline (Print_scene.text scene names); 0
  | [ scene; log ] -> verify scene log
  | _ -> prerr_string usage; 2

let () =
  let fail code text = prerr_endline ("taut-verified: " ^ text); exit code in
  match run (List.tl (Array.to_list Sys.argv)) with
  | code -> exit code
  | exception Scene_reader.Not_covered what -> fail 3 ("not covered: " ^ what)
  | exception Json.Error what -> fail 2 what
  | exception Sys_error what -> fail 2 what
  | exception Stack_overflow -> fail 2 "the scene or the log is too large"
  | exception Exact.Z.Overflow -> fail 2 "a number is too large"
  | exception Out_of_memory -> fail 2 "the scene or the log is too large"
