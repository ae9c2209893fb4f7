# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Where the program looks for what belongs to it, from its own folder up: an installation may be moved as a whole.
set(HANDWHEEL_LIBRARY_FOLDER ${CMAKE_INSTALL_LIBDIR}/handwheel)

# handwheel_room(NAME SOURCES file... [ROOMS room...] [PUBLIC lib...] [PRIVATE lib...])
#
# One shared library per room. Its headers are reachable as "NAME/Header.h" only by targets that link it: the include
# path is a folder that holds nothing but a link to the room. An upward call neither compiles nor links.
function(handwheel_room NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;ROOMS;PUBLIC;PRIVATE" ${ARGN})
  set(include_root ${CMAKE_BINARY_DIR}/rooms/${NAME})
  file(MAKE_DIRECTORY ${include_root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_root}/${NAME} SYMBOLIC)

  handwheel_library(hw_${NAME} "${ARG_SOURCES}" "${ARG_ROOMS}" "${ARG_PUBLIC}" "${ARG_PRIVATE}")
  target_include_directories(hw_${NAME} PUBLIC ${include_root})
endfunction()

# handwheel_kind(ROOM KIND SOURCES file... [ROOMS room...] [PUBLIC lib...] [PRIVATE lib...])
#
# What a room has for one kind of document: the folder KIND of the room, whose headers are "ROOM/KIND/Header.h", as a
# library of its own, hw_ROOM_KIND. It links the room; nothing in the room links it.
function(handwheel_kind ROOM KIND)
  cmake_parse_arguments(ARG "" "" "SOURCES;ROOMS;PUBLIC;PRIVATE" ${ARGN})
  list(TRANSFORM ARG_SOURCES PREPEND ${KIND}/)
  list(PREPEND ARG_ROOMS ${ROOM})
  handwheel_library(hw_${ROOM}_${KIND} "${ARG_SOURCES}" "${ARG_ROOMS}" "${ARG_PUBLIC}" "${ARG_PRIVATE}")
endfunction()

function(handwheel_library TARGET SOURCES ROOMS PUBLIC PRIVATE)
  add_library(${TARGET} SHARED ${SOURCES})
  if(NOT HANDWHEEL_SANITIZE)  # the runtimes of sanitizers are resolved only when the program links
    target_link_options(${TARGET} PRIVATE -Wl,--no-undefined)
  endif()
  list(TRANSFORM ROOMS PREPEND hw_)
  target_link_libraries(${TARGET} PUBLIC ${ROOMS} ${PUBLIC} PRIVATE ${PRIVATE})
  handwheel_target(${TARGET})
  set_target_properties(${TARGET} PROPERTIES INSTALL_RPATH $ORIGIN AUTOMOC_EXECUTABLE ${HANDWHEEL_MOC})
  install(TARGETS ${TARGET} LIBRARY DESTINATION ${HANDWHEEL_LIBRARY_FOLDER})
endfunction()

# handwheel_first_libraries(TARGET): the program names first the libraries in which most symbols are found. Each symbol is
# looked for in one library after the other at every start, in this order: it takes a quarter less time.
function(handwheel_first_libraries TARGET)
  if(NOT HANDWHEEL_SANITIZE)  # the runtimes of sanitizers come before anything else
    get_property(libraries GLOBAL PROPERTY HANDWHEEL_FIRST_LIBRARIES)
    target_link_options(${TARGET} PRIVATE LINKER:--push-state,--no-as-needed -lstdc++ ${libraries} LINKER:--pop-state)
  endif()
endfunction()

# handwheel_target(TARGET): how each library and program of the project is compiled.
function(handwheel_target TARGET)
  handwheel_units(${TARGET})
  target_compile_options(${TARGET} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(HANDWHEEL_UNIT_SOURCES GREATER 1 AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # GCC takes the sources of a unit for headers, where a class must not hold what only one source knows.
    target_compile_options(${TARGET} PRIVATE -Wno-subobject-linkage)
  endif()
  if(HANDWHEEL_WERROR)
    target_compile_options(${TARGET} PRIVATE -Werror)
  endif()
endfunction()
# Files are named relative to the checkout, so that the objects of another one are found in the compiler's cache. gcovr
# needs the absolute names.
if(NOT CMAKE_CXX_FLAGS MATCHES "--coverage")
  file(REAL_PATH ${PROJECT_SOURCE_DIR} real_source_dir)
  add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
  if(NOT real_source_dir STREQUAL PROJECT_SOURCE_DIR)
    add_compile_options(-ffile-prefix-map=${real_source_dir}=.)
  endif()
endif()
option(HANDWHEEL_WERROR "Warnings are errors" OFF)
set(HANDWHEEL_SANITIZE "" CACHE STRING "Sanitizers, for example address,undefined")
if(HANDWHEEL_SANITIZE)
  add_compile_options(-fsanitize=${HANDWHEEL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  # GCC's analysis does not see through the checks that it adds, and reports members of OpenMesh and Eigen.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_link_options(-fsanitize=${HANDWHEEL_SANITIZE})
endif()
