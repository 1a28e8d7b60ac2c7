# Shaders as C: each file becomes an array of its lines, and `gl_sources` names them all. So the
# program needs no files beside it, and the build nothing but awk.
#
# usage: awk -f embed.awk FILES... > sources.c
BEGIN {
    count = 0
    print "// Made by embed.awk."
    print "#include \"source.h\""
}
FNR == 1 {
    if (count > 0) {
        print "    NULL,\n};"
    }
    name = FILENAME
    sub(/.*\//, "", name)
    names[count] = name
    printf "static const char *const lines_%d[] = {\n", count++
}
{
    gsub(/\\/, "&&")
    gsub(/"/, "\\\"")
    printf "    \"%s\\n\",\n", $0
}
END {
    print "    NULL,\n};"
    print "const gl_source gl_sources[] = {"
    for (i = 0; i < count; i++) {
        printf "    {\"%s\", lines_%d},\n", names[i], i
    }
    print "    {NULL, NULL},\n};"
}
