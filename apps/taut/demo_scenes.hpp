// Scenes of examples/ that the build puts into the command.
#pragma once

namespace taut::cli {

extern const char* const lid_scene;
extern const char* const parking_scene;
extern const char* const room_scene;

}  // namespace taut::cli
