# The interface's and the charts' fonts are shipped in assets/fonts. A source package that leaves fonts out gets the
# system's own (Debian: fonts-noto-core) copied beside the executables, where asset_path() looks too.
foreach(font NotoSans-Regular NotoSans-Bold NotoSansMath-Regular)
  if(EXISTS ${PROJECT_SOURCE_DIR}/assets/fonts/${font}.ttf)
    continue()
  endif()
  find_file(PUSHFORWARD_FONT_${font} ${font}.ttf
    PATHS /usr/share/fonts/truetype/noto /usr/share/fonts/noto /usr/share/fonts/google-noto /usr/share/fonts/TTF
      /opt/homebrew/share/fonts /Library/Fonts
    NO_DEFAULT_PATH)
  if(NOT PUSHFORWARD_FONT_${font})
    message(FATAL_ERROR "${font}.ttf is neither in assets/fonts nor installed (Debian: fonts-noto-core)")
  endif()
  file(COPY ${PUSHFORWARD_FONT_${font}} DESTINATION ${PROJECT_BINARY_DIR}/assets/fonts)
endforeach()
