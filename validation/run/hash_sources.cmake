# cmake -DROOT=... -DOUT=... -P hash_sources.cmake: writes a header with eight digits that name what the program is made of: the sources of its
# four folders, by name and content.
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
