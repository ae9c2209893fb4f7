# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
# Plugins are found here, relative to the program: the same in the build folder and where it is installed.
set(HANDWHEEL_PLUGIN_FOLDER ${HANDWHEEL_LIBRARY_FOLDER}/plugins)

# handwheel_device_library(NAME SOURCES file...): the protocol of a device, without its transport: what tests drive. Its
# headers are reachable as "NAME/Header.h", as those of a room are.
function(handwheel_device_library NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES" ${ARGN})
  set(include_root ${CMAKE_BINARY_DIR}/rooms/${NAME})
  file(MAKE_DIRECTORY ${include_root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_root}/${NAME} SYMBOLIC)
  add_library(device_${NAME} STATIC ${ARG_SOURCES})
  set_target_properties(device_${NAME} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(device_${NAME} PUBLIC ${include_root})
  target_link_libraries(device_${NAME} PUBLIC hw_base hw_haptics)
  if(NOT NAME STREQUAL io)
    target_link_libraries(device_${NAME} PUBLIC device_io)
  endif()
  handwheel_target(device_${NAME})
endfunction()

# handwheel_device_plugin(NAME [SOURCES file...] [LIBS lib...]): the plugin on top of it, from Plugin.cpp, with what needs
# the libraries of the device.
function(handwheel_device_plugin NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  add_library(plugin_${NAME} MODULE Plugin.cpp ${ARG_SOURCES})
  set_target_properties(plugin_${NAME} PROPERTIES AUTOMOC ON PREFIX "" OUTPUT_NAME ${NAME}
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${HANDWHEEL_PLUGIN_FOLDER})
  if(NOT HANDWHEEL_SANITIZE)
    target_link_options(plugin_${NAME} PRIVATE -Wl,--no-undefined)
  endif()
  target_link_libraries(plugin_${NAME} PRIVATE device_${NAME} Qt6::Core ${ARG_LIBS})
  handwheel_target(plugin_${NAME})
endfunction()

# handwheel_device_guard(NAME [SOURCES file...] [LIBS lib...]): the process that holds the device for the program, so that
# its motors stop when that dies, from Guard.cpp. The plugin finds it in the folder beside its own.
set(HANDWHEEL_GUARD_FOLDER ${HANDWHEEL_LIBRARY_FOLDER}/guards)
function(handwheel_device_guard NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(guard_${NAME} Guard.cpp ${ARG_SOURCES})
  set_target_properties(guard_${NAME} PROPERTIES OUTPUT_NAME ${NAME} INSTALL_RPATH $ORIGIN/..
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${HANDWHEEL_GUARD_FOLDER})
  target_link_libraries(guard_${NAME} PRIVATE device_${NAME} ${ARG_LIBS})
  handwheel_target(guard_${NAME})
  add_dependencies(handwheel guard_${NAME})
  install(TARGETS guard_${NAME} RUNTIME DESTINATION ${HANDWHEEL_GUARD_FOLDER})
endfunction()

# handwheel_post_plugin(NAME SOURCES file...): the post of a controller, from Plugin.cpp and its sources, whose headers are
# reachable as "NAME/Header.h".
function(handwheel_post_plugin NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES" ${ARGN})
  set(include_root ${CMAKE_BINARY_DIR}/rooms/post_${NAME})
  file(MAKE_DIRECTORY ${include_root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_root}/${NAME} SYMBOLIC)
  add_library(post_${NAME} MODULE Plugin.cpp ${ARG_SOURCES})
  set_target_properties(post_${NAME} PROPERTIES AUTOMOC ON PREFIX "" OUTPUT_NAME ${NAME}
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${HANDWHEEL_PLUGIN_FOLDER}/posts)
  if(NOT HANDWHEEL_SANITIZE)
    target_link_options(post_${NAME} PRIVATE -Wl,--no-undefined)
  endif()
  target_include_directories(post_${NAME} PRIVATE ${include_root})
  target_link_libraries(post_${NAME} PRIVATE hw_robot Qt6::Core)
  handwheel_target(post_${NAME})
endfunction()

# handwheel_install_plugin(NAME): for users, who get it wherever they get the program.
function(handwheel_install_plugin NAME)
  set_target_properties(plugin_${NAME} PROPERTIES INSTALL_RPATH $ORIGIN/..)
  add_dependencies(handwheel plugin_${NAME})
  install(TARGETS plugin_${NAME} LIBRARY DESTINATION ${HANDWHEEL_PLUGIN_FOLDER})
endfunction()

# handwheel_reader(NAME SOURCES file... [LIBS lib...]): the process that reads files of a format, for a library whose
# parser is not proof against hostile ones. core/process/IsolatedReader.h finds it in the folder beside the libraries.
set(HANDWHEEL_READER_FOLDER ${HANDWHEEL_LIBRARY_FOLDER}/readers)
add_custom_target(readers)
function(handwheel_reader NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  set(include_root ${CMAKE_BINARY_DIR}/rooms/reader_${NAME})
  file(MAKE_DIRECTORY ${include_root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_root}/${NAME} SYMBOLIC)
  add_executable(reader_${NAME} ${ARG_SOURCES})
  set_target_properties(reader_${NAME} PROPERTIES OUTPUT_NAME ${NAME} INSTALL_RPATH $ORIGIN/..
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/readers)
  target_include_directories(reader_${NAME} PRIVATE ${include_root})
  target_link_libraries(reader_${NAME} PRIVATE hw_process ${ARG_LIBS})
  handwheel_target(reader_${NAME})
  add_dependencies(readers reader_${NAME})
  add_dependencies(handwheel reader_${NAME})
  install(TARGETS reader_${NAME} RUNTIME DESTINATION ${HANDWHEEL_READER_FOLDER})
endfunction()
