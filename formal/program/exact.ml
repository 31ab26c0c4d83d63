(* The integers of zarith, whose name the extracted program takes for itself. *)
module Z = Z
