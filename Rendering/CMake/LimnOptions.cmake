# What every target of ours is compiled with.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# A fused multiply-add rounds once where two instructions round twice: with it, the picture would
# depend on the instruction set and on the compiler's mood (DESIGN, "the same bytes everywhere").
add_compile_options(-ffp-contract=off -fno-fast-math)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # gcc 12's vectorizer takes (double)(float)x for x, so that x - (double)(float)x becomes 0. Our
  # kernels are vectors already.
  add_compile_options(-fno-tree-vectorize)
endif()
if(LIMN_SANITIZE)
  add_compile_options(-fsanitize=${LIMN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${LIMN_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # With the checks of both sanitizers in it, points-to analysis takes ten minutes over one file.
    add_compile_options(-fno-tree-pta)
  endif()
endif()

# For the core, its tests and the parts of the plugin that are not VTK classes.
add_library(limn_warnings INTERFACE)
target_compile_options(limn_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(LIMN_WERROR)
  add_compile_options(-Werror)
endif()
