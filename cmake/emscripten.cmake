# What a WebAssembly build needs besides the toolchain file. Included for the target taut_options.

taut_system_headers(taut_options boost/version.hpp nlohmann/json.hpp fmt/format.h)

# Exceptions by the WebAssembly proposal, not emulated in JavaScript.
target_compile_options(taut_options INTERFACE -fwasm-exceptions)
target_link_options(taut_options INTERFACE -fwasm-exceptions -sALLOW_MEMORY_GROWTH=1 -sNODEJS_CATCH_EXIT=0
                                           -sNODEJS_CATCH_REJECTION=0)
