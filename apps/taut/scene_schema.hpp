// docs/taut-scene-1.schema.json, which the build puts into the command.
#pragma once

namespace taut::cli {

extern const char* const scene_schema;

}  // namespace taut::cli
