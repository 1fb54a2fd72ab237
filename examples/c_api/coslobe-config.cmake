# find_package(coslobe CONFIG REQUIRED), then target_link_libraries(... coslobe::coslobe).
get_filename_component(_coslobe_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET coslobe::coslobe)
  add_library(coslobe::coslobe STATIC IMPORTED)
  set_target_properties(coslobe::coslobe PROPERTIES
    IMPORTED_LOCATION "${_coslobe_prefix}/lib/libcoslobe.a"
    INTERFACE_INCLUDE_DIRECTORIES "${_coslobe_prefix}/include")
endif()
unset(_coslobe_prefix)
