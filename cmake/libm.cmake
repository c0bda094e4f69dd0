# plico_musl.o: the few functions of musl's libm that base/libm.h declares, taken from Debian's musl-dev and compiled once
# for all: glibc has several sines and chooses by processor (with FMA or without), so the last bit would depend on it.
# What they call themselves comes with them and is visible to nobody; what they are called cannot meet glibc's names.
# Sets PLICO_LIBM to the object, for the target of this folder that takes it as a source.
string(REPLACE gnu musl musl_architecture "${CMAKE_LIBRARY_ARCHITECTURE}")
find_file(PLICO_MUSL libc.a PATHS /usr/lib/${musl_architecture} NO_DEFAULT_PATH REQUIRED
          DOC "musl's static C library (Debian: musl-dev)")
# Those of binutils, whatever the compiler: LLVM's linker wants an object to know its target by.
find_program(PLICO_LD ld.bfd REQUIRED)
find_program(PLICO_OBJCOPY objcopy REQUIRED)

set(take "")
set(rename "")
foreach(function acos asin atan2 cos hypot log pow sin tan)
  list(APPEND take -u ${function})
  list(APPEND rename --redefine-sym ${function}=plico_musl_${function} --keep-global-symbol=plico_musl_${function})
endforeach()
set(PLICO_LIBM ${CMAKE_CURRENT_BINARY_DIR}/plico_musl.o)
add_custom_command(
  OUTPUT ${PLICO_LIBM}
  COMMAND ${PLICO_LD} -r ${take} -o ${PLICO_LIBM} ${PLICO_MUSL}
  COMMAND ${PLICO_OBJCOPY} ${rename} ${PLICO_LIBM}
  DEPENDS ${PLICO_MUSL} COMMENT "Taking sin, cos, ... from musl" VERBATIM)
set_source_files_properties(${PLICO_LIBM} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
