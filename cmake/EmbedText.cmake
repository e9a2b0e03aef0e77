# embed_text(TARGET NAMESPACE FILE...): makes each text file (a shader, a page template) a C++ constant.
#
# methods/shss.vert becomes `extern const std::string_view shss_vert` in NAMESPACE, declared in the
# generated header <folder>/shss.vert.h, which is included from the root like any other.

function(embed_text target namespace)
    set(outputs "")
    foreach(file IN LISTS ARGN)
        cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE source)
        cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE relative)
        cmake_path(GET source FILENAME name)
        string(MAKE_C_IDENTIFIER ${name} identifier)
        set(generated ${PROJECT_BINARY_DIR}/embedded/${relative})
        add_custom_command(
            OUTPUT ${generated}.cpp ${generated}.h
            COMMAND ${CMAKE_COMMAND} -D SOURCE=${source} -D OUTPUT=${generated} -D INCLUDE=${relative}.h
                    -D IDENTIFIER=${identifier} -D NAMESPACE=${namespace}
                    -P ${PROJECT_SOURCE_DIR}/cmake/EmbedOneText.cmake
            DEPENDS ${source} ${PROJECT_SOURCE_DIR}/cmake/EmbedOneText.cmake
            VERBATIM)
        target_sources(${target} PRIVATE ${generated}.cpp ${generated}.h)
        set_source_files_properties(${generated}.cpp TARGET_DIRECTORY ${target} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
        list(APPEND outputs ${generated}.cpp ${generated}.h)
    endforeach()
    # A custom command is known only where it is added; the target may have been made a folder above.
    string(SHA1 tag "${target} ${outputs}")
    string(SUBSTRING ${tag} 0 8 tag)
    add_custom_target(embed_${target}_${tag} DEPENDS ${outputs})
    add_dependencies(${target} embed_${target}_${tag})
    target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/embedded)
endfunction()
