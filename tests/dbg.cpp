#include "volume/SurfaceToVolume.h"
#include "volume/VolumeToSurface.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/simplify/Decimation.h"
#include <fstream>
#include <iostream>
#include <sstream>
#include <time.h>
using namespace handwheel;
double cpu(){ timespec t; clock_gettime(CLOCK_PROCESS_CPUTIME_ID,&t); return t.tv_sec+1e-9*t.tv_nsec; }
int main(int, char**v){ std::ifstream f(v[1]); TriangleSoup s; std::string line; while(std::getline(f,line)){ std::istringstream i(line); std::string w; i>>w; if(w=="v"){double x,y,z;i>>x>>y>>z; s.points.push_back(Vec3(x,y,z));} else if(w=="f"){ std::vector<uint32_t> q; std::string a; while(i>>a) q.push_back(std::stoul(a)-1); for(size_t k=1;k+1<q.size();++k) s.triangles.push_back({q[0],q[k],q[k+1]}); } }
 Box b; for(auto&p:s.points) b.extend(p); double k=90/b.sizes().maxCoeff(); for(auto&p:s.points) p*=k;
 double h=atof(v[2]); double c0=cpu(); auto m=volumeOfSurface(s,h); double c1=cpu(); auto o=surfaceOf(m->volume); double c2=cpu(); auto built=buildMesh(o).mesh; double c3=cpu();
 std::cout<<"volume "<<c1-c0<<" surface "<<c2-c1<<" build "<<c3-c2<<" tris "<<o.triangles.size()<<"\n";
 for(int mode=0;mode<3;++mode){ auto mesh=built; DecimationOptions d; if(mode<2) d.error=0.5*h; d.avoidIntersections=mode==1; if(mode==2){d.faces=s.triangles.size(); d.method=DecimationMethod::Quadric;} double c4=cpu(); auto r=decimate(mesh,d); std::cout<<"mode "<<mode<<" faces "<<r.facesAfter<<" cpu "<<cpu()-c4<<"\n"; } }
