# The headers that are installed: core/nacre.h and all that it includes. The test of what is installed tells of a
# header too few and of one too many.
set(public_library nacre.h)
set(public_base base/error.h base/limits.h base/range.h base/system/file_content.h)
set(public_image image/raster.h)
set(kind_folders ${NACRE_KIND_SETS})
list(TRANSFORM kind_folders REPLACE "(.+)" "model/\\1/*.h")
file(GLOB public_model RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS ${kind_folders} model/kinds/*.h model/*_models.h)
list(APPEND public_model
    model/facet_distribution.h model/layer.h model/lobe.h model/lobe_model.h model/lobes.h model/modulation.h model/picture_source.h
    model/quadrature.h model/retro.h model/shading.h model/shading_members.inl model/spectral/material_list.inc model/spectral/materials.h
    model/tint.h)
set(public_design design/design.h design/design_file.h)
set(public_shading shading/term.h)
set(public_bake
    bake/albedo_values.h bake/bake.h bake/brdf.h bake/brdf_pairs.h bake/brdf_samples.h bake/needs.h bake/symmetry.h bake/table_size.h
    bake/tables.h bake/workers.h)
foreach(room library base image model design shading bake)
    list(TRANSFORM public_${room} PREPEND ${NACRE_ROOMS}/${room}/core/ OUTPUT_VARIABLE headers)
    target_sources(nacre_core
        PUBLIC FILE_SET ${room} TYPE HEADERS BASE_DIRS ${NACRE_ROOMS}/${room} FILES ${headers})
endforeach()
# The text that model/shading.h compiles.
set(public_texts "")
foreach(folder shared ${NACRE_KIND_SETS})
    file(GLOB texts RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/${folder}/*.glsl)
    list(APPEND public_texts ${texts})
endforeach()
list(TRANSFORM public_texts PREPEND ${NACRE_ROOMS}/shaders/)
set(made_headers "")
foreach(set IN LISTS NACRE_KIND_SETS)
    list(APPEND made_headers ${NACRE_GENERATED}/core/model/${set}_list.h ${NACRE_GENERATED}/core/model/${set}_members.inl)
endforeach()
target_sources(nacre_core
    PUBLIC FILE_SET shaders TYPE HEADERS BASE_DIRS ${NACRE_ROOMS}/shaders FILES ${public_texts}
    PUBLIC FILE_SET made TYPE HEADERS BASE_DIRS ${NACRE_GENERATED} FILES ${made_headers})
