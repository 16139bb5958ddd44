#version 330 core
// Every sample that a mesh covers.

out float covered;

void main() {
    covered = 1.0;
}
