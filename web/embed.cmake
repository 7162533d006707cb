# cmake -DOUT=folder -DASSETS="/path=file;…" -P embed.cmake
# Compresses each file and writes assets.S, which takes the bytes in as they are (.incbin), and assets.cpp, the table.
find_program(gzip gzip REQUIRED)
set(mime_html "text/html; charset=utf-8")
set(mime_css "text/css; charset=utf-8")
set(mime_js "text/javascript; charset=utf-8")
set(mime_svg "image/svg+xml")
set(mime_txt "text/plain; charset=utf-8")

set(assembly ".section .rodata\n")
set(declarations "")
set(rows "")
set(number 0)
foreach(asset ${ASSETS})
  string(REGEX MATCH "^([^=]+)=(.+)$" _ "${asset}")
  set(path "${CMAKE_MATCH_1}")
  set(file "${CMAKE_MATCH_2}")
  set(packed "${OUT}/asset_${number}.gz")
  execute_process(COMMAND ${gzip} -9nc INPUT_FILE "${file}" OUTPUT_FILE "${packed}" COMMAND_ERROR_IS_FATAL ANY)
  file(SHA256 "${file}" digest)
  string(REGEX MATCH "[a-z]+$" ending "${path}")
  if(NOT DEFINED mime_${ending})
    message(FATAL_ERROR "${file}: no media type is known for .${ending}")
  endif()
  string(APPEND assembly
    ".global continua_asset_${number}\n.global continua_asset_${number}_end\n"
    "continua_asset_${number}:\n.incbin \"${packed}\"\ncontinua_asset_${number}_end:\n.byte 0\n")
  string(APPEND declarations "extern const char continua_asset_${number}[], continua_asset_${number}_end[];\n")
  string(APPEND rows "      {\"${path}\", \"${mime_${ending}}\", R\"(\"${digest}\")\", "
                     "held(continua_asset_${number}, continua_asset_${number}_end)},\n")
  math(EXPR number "${number} + 1")
endforeach()
string(APPEND assembly ".section .note.GNU-stack,\"\",%progbits\n")

file(WRITE "${OUT}/assets.S" "${assembly}")
file(WRITE "${OUT}/assets.cpp" "#include \"continua/web/assets.h\"

extern \"C\" {
${declarations}}

namespace continua {
namespace {
std::string_view held(const char* from, const char* to) { return {from, static_cast<std::size_t>(to - from)}; }
}  // namespace

std::span<const WebAsset> web_assets() {
  static const WebAsset assets[] = {
${rows}  };
  return assets;
}

}  // namespace continua
")
