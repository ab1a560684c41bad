# cmake -DROOT=... -DOUT=... -P hash_sources.cmake
# Writes a header with eight hexadecimal digits that identify the sources of the program: a hash of
# the names and contents of the files in its four folders.
set(all "")
foreach(folder stats estimators render validation)
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
  foreach(file ${files})
    file(SHA256 ${ROOT}/${file} hash)
    string(APPEND all "${file} ${hash}\n")
  endforeach()
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING ${hash} 0 8 digits)
file(WRITE ${OUT} "#pragma once\n\nnamespace fairlight {\n\ninline constexpr const char* source_digits = \"${digits}\";\n\n}  // namespace fairlight\n")
