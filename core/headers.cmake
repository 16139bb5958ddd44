# The headers that are installed: core/nacre.h and all that it includes. The test of what is installed tells of a
# header too few and of one too many.
file(GLOB public_headers CONFIGURE_DEPENDS model/lobes/*.h model/fresnel/*.h model/masking/*.h model/diffuse/*.h
    model/kinds/*.h)
list(APPEND public_headers
    nacre.h
    bake/bake.h bake/brdf.h bake/brdf_pairs.h bake/plan.h bake/symmetry.h bake/table_size.h bake/tables.h bake/term.h
    bake/workers.h
    design/design.h design/design_file.h design/error.h
    exchange/file_content.h
    model/diffuse_models.h model/facet_distribution.h model/fresnel_models.h model/limits.h model/lobe.h
    model/lobe_model.h model/lobes.h model/masking_models.h model/modulation.h model/quadrature.h model/raster.h
    model/shading.h model/shading_members.inl model/visible_sampler.h)
# The text that model/shading.h compiles.
file(GLOB public_texts CONFIGURE_DEPENDS ../shaders/shared/*.glsl ../shaders/lobes/*.glsl ../shaders/fresnel/*.glsl
    ../shaders/masking/*.glsl ../shaders/diffuse/*.glsl)
foreach(set IN LISTS NACRE_KIND_SETS)
    list(APPEND made_headers ${NACRE_GENERATED}/core/model/${set}_list.h ${NACRE_GENERATED}/core/model/${set}_members.inl)
endforeach()
target_sources(nacre_core
    PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${public_headers} ${public_texts}
    PUBLIC FILE_SET made TYPE HEADERS BASE_DIRS ${NACRE_GENERATED} FILES ${made_headers})
