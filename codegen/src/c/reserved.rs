//! The identifiers that are taken: C's and C++'s keywords, the names of the standard headers that a
//! firmware is likely to include, POSIX's types, and the macros that compilers predefine.
//!
//! A list only ever grows at its end, for a name that enters it changes the C of those who use it.

/// Keywords of C99, C11, C23 and C++, and object-like macros: nothing can be called so.
const KEYWORDS: &[&str] = &[
    "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum",
    "extern", "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict", "return",
    "short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union", "unsigned", "void",
    "volatile", "while", "bool", "true", "false", "alignas", "alignof", "constexpr", "nullptr",
    "static_assert", "thread_local", "typeof", "asm", "and", "and_eq", "bitand", "bitor", "catch",
    "char8_t", "char16_t", "char32_t", "class", "compl", "concept", "consteval", "constinit",
    "const_cast", "co_await", "co_return", "co_yield", "decltype", "delete", "dynamic_cast", "explicit",
    "export", "friend", "mutable", "namespace", "new", "noexcept", "not", "not_eq", "operator", "or",
    "or_eq", "private", "protected", "public", "reinterpret_cast", "requires", "static_cast",
    "template", "this", "throw", "try", "typeid", "typename", "using", "virtual", "wchar_t", "xor",
    "xor_eq", "fortran", "unix", "linux", "errno", "assert", "complex", "imaginary", "I", "EOF", "NULL",
    "NAN", "INFINITY", "HUGE_VAL", "HUGE_VALF", "HUGE_VALL", "EDOM", "ERANGE", "EILSEQ", "OVERFLOW",
    "UNDERFLOW", "DOMAIN", "SING", "PLOSS", "TLOSS", "M_PI", "M_PI_2", "M_PI_4", "M_1_PI", "M_2_PI",
    "M_E", "M_LN2", "M_LN10", "M_LOG2E", "M_LOG10E", "M_SQRT2", "M_SQRT1_2", "M_2_SQRTPI", "MAXFLOAT",
    "DBL_EPSILON", "DBL_MAX", "DBL_MIN", "DBL_DIG", "FLT_EPSILON", "FLT_MAX", "FLT_MIN", "FLT_DIG",
    "FLT_RADIX", "FLT_EVAL_METHOD", "FLT_ROUNDS", "CHAR_BIT", "INT_MAX", "INT_MIN", "UINT_MAX",
    "LONG_MAX", "LONG_MIN", "ULONG_MAX", "SIZE_MAX", "RAND_MAX", "BUFSIZ", "CLOCKS_PER_SEC", "stdin",
    "stdout", "stderr", "signbit", "isnan", "isinf", "isfinite", "isnormal", "fpclassify", "offsetof",
    "DEBUG", "NDEBUG", "TRUE", "FALSE",
];

/// Functions of the standard library, and of POSIX in the same headers.
const FUNCTIONS: &[&str] = &[
    "abort", "abs", "acos", "acosf", "acosh", "asin", "asinf", "asinh", "atan", "atan2", "atan2f",
    "atanf", "atanh", "atexit", "atof", "atoi", "atol", "bsearch", "calloc", "cbrt", "ceil", "ceilf",
    "clock", "copysign", "copysignf", "cos", "cosf", "cosh", "ctime", "difftime", "div", "erf", "erfc",
    "exit", "exp", "exp2", "expf", "expm1", "fabs", "fabsf", "fdim", "floor", "floorf", "fma", "fmaf",
    "fmax", "fmaxf", "fmin", "fminf", "fmod", "fmodf", "free", "frexp", "gamma", "getenv", "gmtime",
    "hypot", "hypotf", "ilogb", "index", "j0", "j1", "jn", "labs", "ldexp", "ldiv", "lgamma", "llabs",
    "llrint", "llround", "localtime", "log", "log10", "log1p", "log2", "logb", "logf", "lrint",
    "lround", "main", "malloc", "memchr", "memcmp", "memcpy", "memmove", "memset", "mktime", "modf",
    "nan", "nanf", "nearbyint", "nextafter", "perror", "pow", "powf", "printf", "puts", "qsort", "rand",
    "random", "read", "realloc", "remainder", "remove", "remquo", "rename", "rint", "rintf", "round",
    "roundf", "scalb", "scalbn", "signal", "significand", "sin", "sincos", "sinf", "sinh", "sqrt",
    "sqrtf", "srand", "stpcpy", "strcat", "strchr", "strcmp", "strcpy", "strlen", "strtod", "strtol",
    "system", "tan", "tanf", "tanh", "tgamma", "time", "trunc", "truncf", "write", "y0", "y1", "yn",
];

/// Types of the C standard and of POSIX.
const TYPES: &[&str] = &[
    "blkcnt_t", "blksize_t", "cc_t", "clock_t", "clockid_t", "cnd_t", "cookie_io_functions_t",
    "daddr_t", "dev_t", "div_t", "double_t", "fenv_t", "fexcept_t", "float_t", "fpos_t", "fsblkcnt_t",
    "fsfilcnt_t", "fsid_t", "gid_t", "greg_t", "gregset_t", "iconv_t", "id_t", "idtype_t", "imaxdiv_t",
    "in_addr_t", "in_port_t", "ino_t", "int16_t", "int32_t", "int64_t", "int8_t", "intmax_t",
    "intptr_t", "jmp_buf", "key_t", "ldiv_t", "lldiv_t", "loff_t", "locale_t", "max_align_t",
    "mbstate_t", "mcontext_t", "mode_t", "mqd_t", "mtx_t", "nfds_t", "nlink_t", "off_t", "once_flag",
    "pid_t", "ptrdiff_t", "pthread_t", "quad_t", "regex_t", "regoff_t", "register_t", "rlim_t",
    "sa_family_t", "sem_t", "sig_atomic_t", "siginfo_t", "sigset_t", "size_t", "socklen_t", "speed_t",
    "ssize_t", "stack_t", "stat_t", "suseconds_t", "tcflag_t", "thrd_t", "time_t", "timer_t", "tss_t",
    "uid_t", "uint16_t", "uint32_t", "uint64_t", "uint8_t", "uintmax_t", "uintptr_t", "ucontext_t",
    "useconds_t", "va_list", "wait_t", "wctrans_t", "wctype_t", "wint_t", "char_t", "null_t",
    "nullptr_t", "task_t", "thread_t", "queue_t", "event_t", "status_t", "bool_t", "string_t",
];

/// Whether nothing at all may have this name.
pub fn is_keyword(name: &str) -> bool {
    KEYWORDS.contains(&name)
}

/// Whether a local may not have this name: it would hide what the emitted code may call.
pub fn is_reserved_for_locals(name: &str) -> bool {
    is_keyword(name) || FUNCTIONS.contains(&name) || TYPES.contains(&name)
}

/// Whether a name of global reach may not be this one.
pub fn is_reserved_globally(name: &str) -> bool {
    is_reserved_for_locals(name)
}
