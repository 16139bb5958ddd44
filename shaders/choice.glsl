// What shaders/shared/ writes in place of a branch, so that it also compiles for many directions at once.

real select(condition c, real yes, real no) {
    return c ? yes : no;
}

real3 select(condition c, real3 yes, real3 no) {
    return c ? yes : no;
}

integer select(condition c, integer yes, integer no) {
    return c ? yes : no;
}

condition none(condition c) {
    return !c;
}
