# Every kind there is, one a line: its set, its name, its struct. The struct stands in core/model/SET/NAME.h, the GLSL that
# goes with it in shaders/SET/NAME.glsl. The order is that of the alternatives of the set's std::variant.
nacre_kind(lobes gaussian GaussianLobe)
nacre_kind(lobes inverse_gaussian InverseGaussianLobe)
nacre_kind(lobes ggx GgxLobe)
nacre_kind(lobes beckmann BeckmannLobe)
nacre_kind(lobes uniform UniformLobe)
nacre_kind(lobes curve CurveLobe)
nacre_kind(lobes painted PaintedLobe)

nacre_kind(fresnel schlick SchlickFresnel)
nacre_kind(fresnel dielectric DielectricFresnel)
nacre_kind(fresnel conductor ConductorFresnel)
nacre_kind(fresnel none NoFresnel)
nacre_kind(fresnel f82 F82Fresnel)
nacre_kind(fresnel measured MeasuredFresnel)
nacre_kind(fresnel film FilmFresnel)
nacre_kind(fresnel curve CurveFresnel)

nacre_kind(masking uncorrelated UncorrelatedMasking)
nacre_kind(masking correlated CorrelatedMasking)
nacre_kind(masking smith_correlated SmithCorrelatedMasking)

nacre_kind(diffuse none NoDiffuse)
nacre_kind(diffuse lambertian LambertianDiffuse)
nacre_kind(diffuse coupled CoupledDiffuse)
nacre_kind(diffuse metal MetalDiffuse)
nacre_kind(diffuse facets FacetDiffuse)

nacre_kind(multibounce none NoMultibounce)
nacre_kind(multibounce rank_one RankOneMultibounce)
nacre_kind(multibounce momentum MomentumMultibounce)

nacre_kind(coat none NoCoat)
nacre_kind(coat clear ClearCoat)
