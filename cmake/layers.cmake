# One static library per line of layers.txt: blockfsi_<layer> from src/<layer>/*.cpp, linked to just the layers
# that its line names. The layers up to `output` need neither PETSc nor MPI: they are the mesh library.

add_library(blockfsi_options INTERFACE)
target_include_directories(blockfsi_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(blockfsi_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                  -Wno-sign-conversion -Wno-psabi -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 wrongly warns of overlapping memcpy inside std::string (GCC bug 105329) of overflows inside
  # fmt, and of uninitialised AVX-512 intrinsics inside Eigen (GCC bug 105593).
  target_compile_options(blockfsi_options INTERFACE -Wno-restrict -Wno-stringop-overflow
                                                    -Wno-maybe-uninitialized)
endif()
if(BLOCKFSI_NATIVE)
  target_compile_options(blockfsi_options INTERFACE -march=native)
endif()
if(BLOCKFSI_SANITIZE)
  target_compile_options(blockfsi_options INTERFACE -fsanitize=${BLOCKFSI_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(blockfsi_options INTERFACE -fsanitize=${BLOCKFSI_SANITIZE})
endif()

# Those that call PETSc or stand on one that does.
set(layers_of_solvers linalg fem fluid solid motion coupling run)

# External libraries per layer.
set(needs_core fmt::fmt)
set(needs_element Eigen3::Eigen)
set(needs_mesh Eigen3::Eigen)
set(needs_block Eigen3::Eigen)
set(needs_output ZLIB::ZLIB EXPAT::EXPAT)
set(needs_linalg PkgConfig::PETSC MPI::MPI_C)
set(needs_case PkgConfig::TOMLPLUSPLUS)

# The same node of different shares is computed in loops that are compiled differently: fused products and sums would
# round it differently.
file(GLOB kernels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/block/kernel*.cpp
  ${PROJECT_SOURCE_DIR}/src/block/resample.cpp ${PROJECT_SOURCE_DIR}/src/block/triangle_nodes.cpp)
set_source_files_properties(${kernels} PROPERTIES COMPILE_OPTIONS -ffp-contract=off)

# What a layer includes but does not call: the parameters of solvers are headers, so that cases are read without.
set(headers_only_case linalg fem fluid solid motion coupling)

file(STRINGS ${PROJECT_SOURCE_DIR}/layers.txt lines REGEX "^[a-z]+:")
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS layers.txt)
foreach(line ${lines})
  string(REGEX MATCH "^[a-z]+" layer "${line}")
  string(REGEX REPLACE "^[a-z]+:" "" uses "${line}")
  separate_arguments(uses)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${layer}/*.cpp)
  if(NOT sources OR (layer IN_LIST layers_of_solvers AND NOT BLOCKFSI_SOLVERS))
    continue()
  endif()
  add_library(blockfsi_${layer} STATIC ${sources})
  target_link_libraries(blockfsi_${layer} PRIVATE blockfsi_options)
  target_include_directories(blockfsi_${layer} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  foreach(used ${uses})
    if(TARGET blockfsi_${used} AND NOT used IN_LIST headers_only_${layer})
      target_link_libraries(blockfsi_${layer} PUBLIC blockfsi_${used})
    endif()
  endforeach()
  if(layer STREQUAL "linalg")
    target_link_libraries(blockfsi_linalg PRIVATE ${needs_linalg})
    # The C++ bindings of MPI are not used and would have to be linked.
    target_compile_definitions(blockfsi_linalg PRIVATE OMPI_SKIP_MPICXX)
  else()
    target_link_libraries(blockfsi_${layer} PUBLIC ${needs_${layer}})
  endif()
  if(layer STREQUAL "geometry" AND BLOCKFSI_CAD)
    target_link_libraries(blockfsi_geometry PRIVATE blockfsi_cad_reader)
  endif()
  list(APPEND BLOCKFSI_LAYERS ${layer})
endforeach()
