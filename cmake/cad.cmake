# Open CASCADE for CAD files, used by src/geometry/cad_occt.cpp alone. Its own package file wants all of its libraries,
# windows and graphics too, so only those that are used are found here.

find_path(OCCT_INCLUDE Standard_Version.hxx PATH_SUFFIXES opencascade)
add_library(blockfsi_cad_reader INTERFACE)
add_library(blockfsi_cad_writer INTERFACE)
function(link_occt target)
  foreach(library ${ARGN})
    find_library(OCCT_${library} ${library})
    if(NOT OCCT_${library} OR NOT OCCT_INCLUDE)
      message(FATAL_ERROR "Open CASCADE's ${library} is missing: install libocct-data-exchange-dev (Debian), or do without "
                          "CAD files by -DBLOCKFSI_CAD=OFF")
    endif()
    target_link_libraries(${target} INTERFACE ${OCCT_${library}})
  endforeach()
endfunction()
link_occt(blockfsi_cad_reader TKSTEP TKIGES TKXSBase TKTopAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
target_include_directories(blockfsi_cad_reader SYSTEM INTERFACE ${OCCT_INCLUDE})
target_compile_definitions(blockfsi_cad_reader INTERFACE BLOCKFSI_CAD)
# Tests write the files that they read.
link_occt(blockfsi_cad_writer TKPrim TKGeomAlgo)
target_link_libraries(blockfsi_cad_writer INTERFACE blockfsi_cad_reader)
