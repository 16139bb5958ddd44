#!/bin/sh
# check.sh SOURCE_FOLDER: each room includes and names only what it may.
set -u
cd "$1" || exit 1
wrong=0

# forbid ROOM WHY PATTERN [FOLDER]: no line of the room's C++ may match, comments and the folder of that name aside.
forbid() {
    room=$1 why=$2 pattern=$3
    [ -d "$room" ] || return 0
    found=$(grep -rnE --exclude-dir="${4:-}" --include='*.h' --include='*.cpp' "$pattern" "$room" | grep -vE '^[^:]+:[0-9]+: *//')
    if [ -n "$found" ]; then
        printf '%s: %s\n%s\n' "$room" "$why" "$found"
        wrong=1
    fi
}

opengl='# *include *[<"](GL|GLES[23]?|EGL|GLFW|OSMesa)/|\bgl(Gen|Bind|Draw|Tex|Uniform|Get|Enable|Disable|Clear|Create|Delete|Compile|Link|Use|Read|Viewport)[A-Za-z0-9]*\('
imgui='# *include *[<"]imgui|\bImGui::'
glfw='# *include *[<"]GLFW|\bglfw[A-Z]'
files='# *include *[<"](fstream|cstdio|iostream|unistd\.h|fcntl\.h)|\b(std::)?(ifstream|ofstream|fstream|fopen|freopen)\b|filesystem::(exists|remove|rename|directory_iterator|create_directories|status|is_directory|current_path)|\bfs::(exists|remove|rename|directory_iterator|create_directories|status|is_directory|current_path)'
pictures='# *include *[<"]OpenImageIO/'
system='# *include *<(unistd|fcntl|poll|spawn|dlfcn|pthread|sched|time|csignal|signal|termios|sys/[a-z]+)(\.h)?>|\b(environ|localtime_r|setpriority|getrusage)\b|/proc/'
glsl='void main *\( *\)|gl_Frag(Color|Coord)|gl_Position|texelFetch|layout *\( *location'

forbid core 'knows no OpenGL' "$opengl"
forbid core 'knows no Dear ImGui' "$imgui"
forbid core 'knows no window' "$glfw"
forbid core 'looks at nobody above it' '# *include *[<"](ui|app)/'
forbid core/plot 'reads and writes no file' "$files"
forbid ui 'makes no OpenGL call' "$opengl"
forbid ui 'knows no window' "$glfw"
forbid ui 'reads and writes no file' "$(printf %s "$files" | sed 's/|cstdio//')"
forbid ui 'looks at nobody above it' '# *include *[<"]app/'
forbid app/preview 'knows no Dear ImGui' "$imgui"
forbid app/preview 'knows no window' "$glfw"
forbid app/designer 'knows no window' "$glfw"
forbid app/headless 'knows no window' "$glfw"
forbid app/cli 'knows no window' "$glfw"
forbid core 'holds no shader text: it stands in shaders/' "$glsl"
forbid ui 'holds no shader text: it stands in shaders/' "$glsl"
for room in core ui app; do
    forbid $room 'reads and writes pictures through core/pictures alone' "$pictures" pictures
    forbid $room 'calls the operating system through core/base/system alone' "$system" system
done
forbid app 'holds no shader text: it stands in shaders/' "$glsl"

exit $wrong
