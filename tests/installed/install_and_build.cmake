# Installs the build to a prefix of its own, then configures, builds and runs programs against it, as their authors do.
set(work ${BUILD_DIR}/installed_package)
file(REMOVE_RECURSE ${work})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${work}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# build_and_run(NAME FOLDER OPTIONS...): the program NAME of the project in FOLDER.
function(build_and_run name folder)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${folder} -B ${work}/${name} -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${work}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${work}/${name} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${work}/${name}/${name} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

build_and_run(consumer ${CONSUMER_DIR})
build_and_run(bsdf ${CONSUMER_DIR}/bsdf -DPAGE_DIR=${PAGE_DIR})
# On a machine that has no library of pictures.
set(without "")
foreach(package OpenEXR PNG nlohmann_json CLI11)
  list(APPEND without -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
build_and_run(statistics ${CONSUMER_DIR}/statistics ${without})

# A component that there is not is named.
file(WRITE ${work}/wrong/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(wrong LANGUAGES NONE)\n"
  "find_package(fairlight REQUIRED COMPONENTS statistics)\n")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${work}/wrong -B ${work}/wrong/build -DCMAKE_PREFIX_PATH=${work}/prefix
  RESULT_VARIABLE status ERROR_VARIABLE said OUTPUT_QUIET)
if(status EQUAL 0 OR NOT said MATCHES "there is no component statistics")
  message(FATAL_ERROR "a component that there is not was found: ${said}")
endif()

# pkg-config knows the flags.
set(ENV{PKG_CONFIG_PATH} ${work}/prefix/lib/pkgconfig)
file(GLOB pc ${work}/prefix/lib/*/pkgconfig)
if(pc)
  set(ENV{PKG_CONFIG_PATH} ${pc})
endif()
find_program(pkg_config pkg-config)
if(pkg_config)
  execute_process(COMMAND ${pkg_config} --libs fairlight-stats OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  if(NOT flags MATCHES "-lfairlight_stats")
    message(FATAL_ERROR "pkg-config says: ${flags}")
  endif()
endif()
