# Makes from the list of kinds, for each set of them:
#
#   SET_list.h      includes every kind's header; NACRE_SET is their structs, separated by commas
#   SET_members.inl the kinds' GLSL for core/model/shading_members.inl, and EACH_CASE: a CASE_CASE(index, function...) each
#
# Of each set: what its cases are called, then the suffixes of the functions that NAME.glsl defines.
set(NACRE_KIND_SETS lobes fresnel masking diffuse multibounce coat)
set(NACRE_CASES_lobes LOBE _lobe)
set(NACRE_CASES_fresnel FRESNEL _fresnel)
set(NACRE_CASES_masking MASKING _masking)
set(NACRE_CASES_diffuse DIFFUSE _share _diffuse _diffuse_albedo)
set(NACRE_CASES_multibounce MULTIBOUNCE _amplitude _row _spread _kernel)
set(NACRE_CASES_coat COAT _density _area)

# nacre_kind(SET NAME STRUCT): a line of core/model/kinds.cmake.
macro(nacre_kind set name struct)
    list(APPEND NACRE_KINDS_${set} ${name})
    list(APPEND NACRE_STRUCTS_${set} ${struct})
endmacro()

function(nacre_write_kinds list_file folder)
    foreach(set IN LISTS NACRE_KIND_SETS)
        set(NACRE_KINDS_${set})
        set(NACRE_STRUCTS_${set})
    endforeach()
    include(${list_file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list_file})
    foreach(set IN LISTS NACRE_KIND_SETS)
        set(suffixes ${NACRE_CASES_${set}})
        list(POP_FRONT suffixes case)
        set(headers "")
        set(texts "")
        set(cases "")
        set(index 0)
        foreach(name IN LISTS NACRE_KINDS_${set})
            string(APPEND headers "#include \"core/model/${set}/${name}.h\"\n")
            string(APPEND texts "#include \"shaders/${set}/${name}.glsl\"\n")
            string(APPEND cases " \\\n    ${case}_CASE(${index}")
            foreach(suffix IN LISTS suffixes)
                string(APPEND cases ", ${name}${suffix}")
            endforeach()
            string(APPEND cases ")")
            math(EXPR index "${index} + 1")
        endforeach()
        list(JOIN NACRE_STRUCTS_${set} ", " structs)
        string(TOUPPER ${set} upper)
        file(CONFIGURE OUTPUT ${folder}/core/model/${set}_list.h @ONLY CONTENT
"// Made of core/model/kinds.cmake.
#pragma once

@headers@
#define NACRE_@upper@ @structs@
")
        file(CONFIGURE OUTPUT ${folder}/core/model/${set}_members.inl @ONLY CONTENT
"// Made of core/model/kinds.cmake.
@texts@
#define EACH_@case@@cases@
")
    endforeach()
endfunction()
