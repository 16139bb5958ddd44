#include "core/formats/export_program.h"

#include "core/formats/glsl_parser.h"
#include "core/formats/sampling_table.h"
#include "core/shading/shader_variant.h"

namespace nacre {

ExportProgram export_program(const Tables& tables) {
    const ShaderVariant variant = variant_of(tables.shading);
    const SamplingTable sampling = sampling_table(tables);
    const std::string text =
        variant_definitions(variant) + "#undef LARGEST\n" + shared_parameters(variant) +
        "\n// A number of the tables.\nfloat fetch(int index) {\n    return data[index];\n}\n\n" +
        shared_mathematics(variant) + "\n" + sampling_mathematics(tables, sampling, tables.data.size());
    ExportProgram program;
    program.tree = parse_glsl(text, {{"float[]", "data"},
                                     {"Surface", "surface"},
                                     {"Layer[]", "layers"},
                                     {"int", "layer_count"},
                                     {"float", "LARGEST"}});
    program.albedo = !tables.needs.albedo ? "" : variant.kinds.coated() ? "coated_albedo" : "total_albedo";
    program.data = tables.data;
    program.data.insert(program.data.end(), sampling.values.begin(), sampling.values.end());
    return program;
}

}  // namespace nacre
