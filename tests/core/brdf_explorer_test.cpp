// The text for BRDF Explorer: its sections, and the shader in them.
#include <doctest/doctest.h>

#include "core/design/design_file.h"
#include "core/formats/export_format.h"
#include "tests/core/compiled_c.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using namespace nacre::test;

TEST_CASE("BRDF Explorer: the shader between its marks compiles") {
    const Design design = load_design(NACRE_SOURCE_DIR "/presets/ggx-steel.nacre");
    const std::string text =
        prepare_export(brdf_explorer_format, design, {.prefix = "steel"}, {}, {}).bytes();
    CHECK(text.starts_with("analytic\n"));
    CHECK(text.find("::begin parameters\n::end parameters\n") != std::string::npos);
    const std::string begin = "::begin shader\n";
    const std::size_t from = text.find(begin), to = text.find("::end shader\n");
    REQUIRE(from != std::string::npos);
    REQUIRE(to != std::string::npos);
    const TemporaryFolder folder;
    write_all(
        folder / "brdf.frag",
        "#version 330 core\n" + text.substr(from + begin.size(), to - from - begin.size()) +
            "in vec3 l, v;\nout vec4 colour;\nvoid main() {\n    colour = vec4(BRDF(l, v, vec3(0, 0, 1), "
            "vec3(1, 0, 0), vec3(0, 1, 0)), 1);\n}\n");
    int code = 1;
    const std::string said = said_by("glslangValidator " + (folder / "brdf.frag").string(), code);
    CHECK_MESSAGE(code == 0, said);
}
