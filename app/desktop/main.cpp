// nacre [DESIGN] [--ui-scale X]
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "app/designer/command.h"
#include "app/designer/imgui_session.h"
#include "app/desktop/key_latch.h"
#include "app/desktop/pace.h"
#include "app/desktop/pen.h"
#include "app/desktop/start_report.h"
#include "app/desktop/window.h"
#include "core/base/system/standard_streams.h"
#include "ui/keys.h"

namespace {

struct Arguments {
    std::string design;
    float ui_scale = 0;  // 0: the monitor's
    bool time_start = false;
};

void run(const Arguments& arguments) {
    const auto reached = [&](const char* stage) {
        if (arguments.time_start) nacre::report_stage(stage);
    };
    reached("main");
    nacre::Window window({1280, 800}, "Nacre");
    reached("window");
    const auto ui_scale = [&] {
        return arguments.ui_scale > 0 ? arguments.ui_scale : window.monitor_scale();
    };
    nacre::ImguiSession session(ui_scale(), window.pixels_a_unit());
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    nacre::KeyLatch keys(window.handle());
    {
        const auto variable = [](const char* name) { return std::getenv(name); };
        nacre::Designer designer({.folders = nacre::user_folders(variable),
                                  .dialogs = nacre::find_dialog_program(variable),
                                  .folder_opener = nacre::find_folder_opener(variable),
                                  .welcomes = true,
                                  .wake = nacre::Window::wake});
        // One that cannot be read is told in the window, which a desktop shows, unlike standard error.
        if (!arguments.design.empty()) nacre::open_at_start(designer, arguments.design);
        nacre::Pace pace;
        nacre::Pen pen;
        reached("designer");
        while (!designer.files.may_quit()) {
            const bool moves = nacre::in_motion(designer) || ImGui::IsAnyMouseDown();
            const bool noticed = window.wait(pace.wait(glfwGetTime(), moves));
            const bool due = pace.due(glfwGetTime(), noticed, ImGui::GetIO().WantTextInput);
            if (window.take_focus()) nacre::notice_focus(designer);
            if (window.take_close_request()) nacre::perform(designer, nacre::quit_command);
            if (!due) continue;
            session.set_scale(ui_scale(), window.pixels_a_unit());
            session.new_frame();
            ImGui_ImplGlfw_NewFrame();
            keys.tell();
            for (const std::string& file : keys.take_dropped()) nacre::take_file(designer, file);
            designer.canvas.state.pressure = pen.pressure();
            designer.focus.tell_pointer(ImGui::GetIO());
            ImGui::NewFrame();
            nacre::draw_frame(designer);
            if (nacre::ui::input_waits()) nacre::Window::notice();
            ImGui::Render();
            session.draw(window.framebuffer_size());
            window.swap();
            if (arguments.time_start && designer.preview.has_picture()) break;
            window.set_title(designer.document.title() + " \u2013 Nacre");
            window.set_full_screen(designer.full_screen);
        }
        reached("picture");
        nacre::finish(designer);
    }
    ImGui_ImplGlfw_Shutdown();
}

}  // namespace

int main(int argc, char** argv) {
    nacre::prepare_streams();
    CLI::App options("Nacre: design the highlight of a surface", "nacre");
    Arguments arguments;
    options.add_option("DESIGN", arguments.design, "a .nacre file to open");
    options.add_option("--ui-scale", arguments.ui_scale, "size of text and widgets; 1 is normal")
        ->check([](const std::string& text) {
            double scale = 0;
            const bool within = CLI::detail::lexical_cast(text, scale) && scale >= 0.5 && scale <= 4;
            return within ? std::string() : text + " is not a number from 0.5 to 4";
        });
    options.set_version_flag("--version", NACRE_VERSION);
    // For tests/bench/start.sh: ends with the first shaded picture and prints when it came.
    options.add_flag("--time-start", arguments.time_start)->group("");
    try {
        options.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return options.exit(error) == 0 ? 0 : 2;
    }
    try {
        run(arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nacre: %s\n", error.what());
        return 1;
    }
    return 0;
}
