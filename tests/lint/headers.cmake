# Every header compiles alone. A source file includes its own header first (the include lint checks
# this). So only a header without a source file needs one here, which includes it and nothing else,
# with the include folders and definitions of all our libraries.

# Our static libraries in a folder and below it.
function(libraries_below folder result)
  set(found)  # a function starts with its caller's variables
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  get_property(subfolders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
      list(APPEND found ${target})
    endif()
  endforeach()
  foreach(subfolder IN LISTS subfolders)
    libraries_below(${subfolder} below)
    list(APPEND found ${below})
  endforeach()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

set(root ${PROJECT_SOURCE_DIR})
file(GLOB_RECURSE headers RELATIVE ${root} CONFIGURE_DEPENDS
     ${root}/config/*.h ${root}/vision/*.h ${root}/haptics/*.h ${root}/audio-cues/*.h ${root}/app/*.h ${root}/tests/*.h)
foreach(header IN LISTS headers)
  cmake_path(REPLACE_EXTENSION header cpp OUTPUT_VARIABLE own_source)
  if(NOT EXISTS ${root}/${own_source})
    set(source ${CMAKE_CURRENT_BINARY_DIR}/alone/${header}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n")
    list(APPEND sources ${source})
  endif()
endforeach()

add_library(touchline_headers OBJECT EXCLUDE_FROM_ALL ${sources})
set_target_properties(touchline_headers PROPERTIES UNITY_BUILD OFF)
target_include_directories(touchline_headers PRIVATE ${root})
target_compile_options(touchline_headers PRIVATE -O0 -g0)
libraries_below(${root} libraries)
foreach(library IN LISTS libraries)
  target_include_directories(touchline_headers SYSTEM PRIVATE $<TARGET_PROPERTY:${library},INCLUDE_DIRECTORIES>)
  target_compile_definitions(touchline_headers PRIVATE $<TARGET_PROPERTY:${library},COMPILE_DEFINITIONS>)
endforeach()

add_test(NAME Lint.HeadersCompileAlone
         COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target touchline_headers)
set_tests_properties(Lint.HeadersCompileAlone PROPERTIES LABELS unit TIMEOUT 900 RUN_SERIAL ON)
