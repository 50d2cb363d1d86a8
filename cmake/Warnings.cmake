# House warnings. They become errors only with CMAKE_COMPILE_WARNING_AS_ERROR (preset ci), so that a
# newer compiler never locks a newcomer out. -Wnull-dereference is left out: GCC 12 raises false
# alarms inside std::vector at -O2.
function(plumbline_warnings target)
    set(common
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wcast-align
        -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion -Wformat=2 -Wimplicit-fallthrough
        -Wextra-semi -Wundef)
    set(gcc -Wduplicated-cond -Wduplicated-branches -Wlogical-op -Wuseless-cast)
    # GCC 12 does not know clang's option and clang 14 not GCC's names; neither needs the other's.
    target_compile_options(${target} PRIVATE
        $<$<COMPILE_LANGUAGE:CXX>:${common}>
        $<$<COMPILE_LANG_AND_ID:CXX,GNU>:${gcc}>
        # A file that is one of several in a unity build is not "the main file".
        $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<COMPILE_LANG_AND_ID:CXX,GNU>>:-Wno-subobject-linkage>
        $<$<COMPILE_LANG_AND_ID:CXX,Clang>:-Wno-missing-field-initializers>
        $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-missing-field-initializers>)
endfunction()

# Where Real is double, float literals widen and casts to Real do nothing by design; the float build is
# the one that watches conversions.
function(plumbline_no_conversion_warnings)
    foreach(target IN LISTS ARGN)
        target_compile_options(${target} PRIVATE
            -Wno-double-promotion -Wno-float-conversion -Wno-conversion
            -Wno-psabi  # vectors of four doubles go between functions of one program only
            $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-useless-cast>)
    endforeach()
endfunction()
