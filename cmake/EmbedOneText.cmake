# Script of embed_text: writes OUTPUT.h and OUTPUT.cpp for one SOURCE.
file(READ ${SOURCE} text)
file(WRITE ${OUTPUT}.h
"#pragma once
#include <string_view>
namespace ${NAMESPACE} { extern const std::string_view ${IDENTIFIER}; }
")
# A string literal may not exceed 65,536 characters in ISO C++: join pieces.
string(LENGTH "${text}" length)
set(literals "")
set(position 0)
while(position LESS length)
    string(SUBSTRING "${text}" ${position} 12000 piece)
    string(APPEND literals "R\"__text__(${piece})__text__\"\n")
    math(EXPR position "${position} + 12000")
endwhile()
if(length EQUAL 0)
    set(literals "\"\"")
endif()
file(WRITE ${OUTPUT}.cpp
"#include \"${INCLUDE}\"
namespace ${NAMESPACE} { const std::string_view ${IDENTIFIER} = ${literals}; }
")
