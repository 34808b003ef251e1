// The specular-colour device (figure 3.1), gate cosine, in its own integers: the same W, bit for
// bit, of the same code of the cosine. Inside the highlight, where t is 0 to 1, products fit
// in 32 bits, the square in two parts.
uniform uint sigma; // ROM 33 at n, U9.13
uniform uint limit; // ROM 9 at n: a cosine, U1.18

const uint one = 262144u; // 1.0 with 18 fraction bits

// t^2, rounded half up, of t up to 1.0.
uint square(uint t)
{
    uint high = t >> 10u, low = t & 1023u;
    uint kept = t * high + (t * low >> 10u); // the square without its ten lowest bits
    return (kept + 128u) >> 8u;
}

float highlight(cosines c)
{
    uint code = min(uint(held(c.nh) * float(one) + 0.5), one);
    if (code < limit)
        return 0.0;
    uint below = one - code;                       // adder 6, its sign turned
    uint fall = (sigma * below + 4095u) >> 13u;    // multiplier 7: half up, of what is negative
    return float(square(one - fall)) / float(one); // adder 8, multiplier 10
}
