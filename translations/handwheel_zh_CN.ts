<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>BodyDragTool</name>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
</context>
<context>
    <name>ClosePrompt</name>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>是否保存对 %1 的更改？</translation>
    </message>
    <message>
        <source>They will be lost if you do not save them.</source>
        <translation>如果不保存，这些更改将丢失。</translation>
    </message>
    <message>
        <source>Documents to save</source>
        <translation>要保存的文档</translation>
    </message>
    <message>
        <source>&amp;Save all</source>
        <translation>全部保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Save the checked</source>
        <translation>保存已勾选的(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard all</source>
        <translation>全部放弃(&amp;D)</translation>
    </message>
    <message numerus="yes">
        <source>Save the changes to %n document(s)?</source>
        <translation>
            <numerusform>是否保存对 %n 个文档的更改？</numerusform>
        </translation>
    </message>
    <message>
        <source>The changes to those that are not checked will be lost.</source>
        <translation>未勾选的文档的更改将会丢失。</translation>
    </message>
</context>
<context>
    <name>DefectModel</name>
    <message>
        <source>Holes</source>
        <translation>孔洞</translation>
    </message>
    <message>
        <source>Non-manifold edges</source>
        <translation>非流形边</translation>
    </message>
    <message>
        <source>Non-manifold vertices</source>
        <translation>非流形顶点</translation>
    </message>
    <message>
        <source>One-sided edges</source>
        <translation>单侧面的边</translation>
    </message>
    <message>
        <source>Inside out</source>
        <translation>内外翻转</translation>
    </message>
    <message>
        <source>Near vertices</source>
        <translation>邻近顶点</translation>
    </message>
    <message>
        <source>Reversed on opening</source>
        <translation>打开时已反转</translation>
    </message>
    <message>
        <source>Degenerate triangles</source>
        <translation>退化三角形</translation>
    </message>
    <message>
        <source>Duplicate triangles</source>
        <translation>重复三角形</translation>
    </message>
    <message>
        <source>Self-intersections</source>
        <translation>自相交</translation>
    </message>
    <message>
        <source>Debris</source>
        <translation>碎片</translation>
    </message>
    <message>
        <source>Places where the surface is missing. (A tunnel through the part is not a hole.)</source>
        <translation>表面缺失之处。（贯穿零件的通道不算孔洞。）</translation>
    </message>
    <message>
        <source>Outer boundaries of open sheets, and holes that you marked to keep open. “Repair all” does not close them.</source>
        <translation>开放片体的外边界，以及您标记为保持开放的孔。“全部修复”不会封闭它们。</translation>
    </message>
    <message>
        <source>Edges at which more than two triangles meet.</source>
        <translation>超过两个三角形共用的边。</translation>
    </message>
    <message>
        <source>Vertices at which parts of the surface touch without sharing an edge.</source>
        <translation>曲面各部分相接但没有公共边的顶点。</translation>
    </message>
    <message>
        <source>Edges at which inside becomes outside: like a Möbius strip, the surface has only one side.</source>
        <translation>内侧在这些边处变为外侧：表面如莫比乌斯带，只有一侧。</translation>
    </message>
    <message>
        <source>Vertices on open edges that differ only by rounding in the file. A repair merges them.</source>
        <translation>开放边上仅因文件取整而不同的顶点。修复时会将其合并。</translation>
    </message>
    <message>
        <source>Bodies whose triangles face inwards, so that inside and outside are swapped.</source>
        <translation>三角形朝内的体，其内外颠倒。</translation>
    </message>
    <message>
        <source>Triangles without area.</source>
        <translation>面积为零的三角形。</translation>
    </message>
    <message>
        <source>Triangles that lie exactly on another one.</source>
        <translation>与另一个完全重合的三角形。</translation>
    </message>
    <message>
        <source>Pieces apart from the largest one, with less than %1 % of its area and less than %2 % of its triangles. “Remove debris” removes all, or only the piece selected here; any other piece is removed with the tool “Select faces”.</source>
        <translation>最大部件以外的碎片，其面积小于最大部件的 %1 %，三角形数小于其 %2 %。“移除碎片”移除全部或仅移除此处选中的一块；其他部分用“选择面”工具移除。</translation>
    </message>
    <message>
        <source>Boundaries kept open</source>
        <translation>保持开放的边界</translation>
    </message>
    <message>
        <source>Inconsistent triangles</source>
        <translation>方向不一致的三角形</translation>
    </message>
    <message>
        <source>Triangles with an orientation opposite to that of their neighbours. Opening a file reverses them, as the first step of the history; they are listed here where that step is undone.</source>
        <translation>与相邻三角形方向相反的三角形。打开文件时会将其反转，作为历史记录的第一步；撤销该步骤后，它们会列在此处。</translation>
    </message>
    <message>
        <source>No longer a defect: triangles with an orientation opposite to that of their neighbours in the file were reversed on opening, as the first step of the history. If the neighbours were wrong, “Reverse faces” reverses the whole shell.</source>
        <translation>不再是缺陷：文件中与相邻三角形方向相反的三角形在打开时已反转，作为历史记录的第一步。如果错误的是相邻三角形，“反转面”可反转整个壳体。</translation>
    </message>
    <message>
        <source>Pairs of triangles that intersect. “Repair all” cuts them along each other and joins them so that none intersects another, where that leaves nothing else worse.</source>
        <translation>相互穿插的三角形对。“全部修复”沿交线将其切开并重新连接，使三角形不再相互穿插，前提是不会使其他方面变差。</translation>
    </message>
</context>
<context>
    <name>DeviceText</name>
    <message>
        <source>Not plugged in</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>正在启动…</translation>
    </message>
    <message>
        <source>Needs homing</source>
        <translation>需要回零</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>No force: the device is not ready.</source>
        <translation>没有力：设备未就绪。</translation>
    </message>
    <message>
        <source>The force rises slowly after a change.</source>
        <translation>变化之后力缓慢上升。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>按钮</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>最大力</translation>
    </message>
    <message>
        <source>Largest torque</source>
        <translation>最大扭矩</translation>
    </message>
    <message>
        <source>Largest force of the grip</source>
        <translation>手柄的最大力</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>Stiffness in rotation</source>
        <translation>转动刚度</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>Radius of the workspace</source>
        <translation>工作空间半径</translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation>伺服频率</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>延迟</translation>
    </message>
    <message>
        <source>Softer than set: %1 of %2 N/mm; limit of the %3 at %4 kHz and %5 ms of delay</source>
        <translation>低于设定刚度：%1 / %2 N/mm；这是 %3 在 %4 kHz、%5 ms 延迟下的上限</translation>
    </message>
    <message>
        <source>Its position is not calibrated yet. Pull the grip slowly all the way out, push it all the way in, and bring it back to the middle. There is no force until then.</source>
        <translation>其位置尚未校准。请缓慢地将手柄完全拉出，再完全推入，然后放回中间。在此之前没有力。</translation>
    </message>
    <message>
        <source>Its position is not calibrated yet. Put the pen into its inkwell and hold it there for a moment; bring a device without an inkwell to its reset position. There is no force until then.</source>
        <translation>其位置尚未校准。请将笔插入笔座并保持片刻；没有笔座的设备请移到复位位置。在此之前没有力。</translation>
    </message>
    <message>
        <source>Its position is not calibrated yet. Calibrate it as described in its manual. There is no force until then.</source>
        <translation>其位置尚未校准。请按照其手册进行校准。在此之前没有力。</translation>
    </message>
    <message>
        <source>Does not respond correctly</source>
        <translation>未正确响应</translation>
    </message>
    <message>
        <source>Connecting; the firmware may be loading. This can take some seconds.</source>
        <translation>正在连接，可能正在加载固件。这可能需要几秒钟。</translation>
    </message>
    <message>
        <source>No force: the requested force is not a number.</source>
        <translation>没有力：请求的力不是数值。</translation>
    </message>
    <message>
        <source>Damped: the device returned more energy than was put in.</source>
        <translation>已施加阻尼：设备输出的能量多于输入的能量。</translation>
    </message>
    <message>
        <source>Damped: it moves faster than a hand normally does.</source>
        <translation>已施加阻尼：其移动速度超过手的正常速度。</translation>
    </message>
    <message>
        <source>No force: it moves as if nobody were holding it.</source>
        <translation>没有力：设备像没人握住一样移动。</translation>
    </message>
    <message>
        <source>The force fades: no update arrived in time.</source>
        <translation>力在减弱：没有及时收到更新。</translation>
    </message>
    <message>
        <source>The rate of change of the force is limited.</source>
        <translation>力的变化率受到限制。</translation>
    </message>
    <message>
        <source>The force is at the limit of the device.</source>
        <translation>力已达到设备的上限。</translation>
    </message>
    <message>
        <source>Softer than set: %1 of %2 N/mm; limit specified for the %3</source>
        <translation>低于设定刚度：%1 / %2 N/mm；这是 %3 的标称上限</translation>
    </message>
    <message>
        <source>The system does not allow the servo loop to run in real time. Ticks are late when the computer is busy, and the stiffness is reduced to allow for that. To permit real time, run this line in a terminal, then log out and in again:</source>
        <translation>系统不允许伺服循环实时运行。计算机繁忙时节拍会延迟，因此降低了刚度。若要允许实时运行，请在终端中执行以下命令，然后注销并重新登录：</translation>
    </message>
    <message>
        <source>Measured axes</source>
        <translation>测量的轴</translation>
    </message>
    <message>
        <source>Actuated axes</source>
        <translation>驱动的轴</translation>
    </message>
    <message>
        <source>Internal damping</source>
        <translation>内部阻尼</translation>
    </message>
    <message>
        <source>Operating mode</source>
        <translation>工作模式</translation>
    </message>
    <message>
        <source>rate control: it springs back, its deflection sets the speed</source>
        <translation>速率控制：自动回弹，偏移量决定速度</translation>
    </message>
    <message>
        <source>Plug it in. If it is not opened automatically then, choose it again.</source>
        <translation>请连接设备。如果之后没有自动打开，请重新选择它。</translation>
    </message>
    <message>
        <source>Unplug it, wait for some seconds, and plug it in. If it is not opened automatically then, choose it again.</source>
        <translation>拔下设备，等待几秒后重新连接。如果之后没有自动打开，请重新选择它。</translation>
    </message>
</context>
<context>
    <name>DiscardedResult</name>
    <message>
        <source>“%1” has changed nothing</source>
        <translation>“%1”没有改变任何内容</translation>
    </message>
    <message>
        <source>%1 was changed meanwhile, and the result was for its state before.</source>
        <translation>%1 在此期间已被更改，而结果针对的是之前的状态。</translation>
    </message>
    <message>
        <source>Start it again if it is still wanted.</source>
        <translation>如仍需要，请重新开始。</translation>
    </message>
</context>
<context>
    <name>DocumentKind</name>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Robot cell</source>
        <translation>机器人单元</translation>
    </message>
    <message>
        <source>Workpiece</source>
        <translation>工件</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体素模型</translation>
    </message>
</context>
<context>
    <name>ErrorText</name>
    <message>
        <source>the file ends too early (%1: %2 expected, %3 found)</source>
        <translation>文件提前结束（%1：应为 %2，实为 %3）</translation>
    </message>
    <message>
        <source>the file ends too early (%1: %3 found)</source>
        <translation>文件提前结束（%1：实为 %3）</translation>
    </message>
    <message>
        <source>the file is too large (more than %3 %1)</source>
        <translation>文件过大（超过 %3 个%1）</translation>
    </message>
    <message>
        <source>the file is too large (%2 %1, at most %3 can be opened)</source>
        <translation>文件过大（%2 个%1，最多可打开 %3 个）</translation>
    </message>
    <message>
        <source>%1 was expected, but nothing follows</source>
        <translation>应为 %1，但后面没有内容</translation>
    </message>
    <message>
        <source>%1 was expected, &apos;%2&apos; was found</source>
        <translation>应为 %1，却是“%2”</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>文件不存在</translation>
    </message>
    <message>
        <source>the file cannot be read (%1)</source>
        <translation>无法读取文件（%1）</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>the header is malformed: %1 is missing</source>
        <translation>文件头有误：缺少 %1</translation>
    </message>
    <message>
        <source>the text is in %1, which cannot be read</source>
        <translation>文本采用 %1 编码，无法读取</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>“%1”不是数字</translation>
    </message>
    <message>
        <source>the coordinate &apos;%1&apos; is not a finite number</source>
        <translation>坐标“%1”不是有限数</translation>
    </message>
    <message>
        <source>a face uses vertex %1, but the file has %2 vertices</source>
        <translation>某个面使用了顶点 %1，但文件只有 %2 个顶点</translation>
    </message>
    <message>
        <source>a face uses vertex %1, which could not be read</source>
        <translation>某个面使用了无法读取的顶点 %1</translation>
    </message>
    <message>
        <source>a face has fewer than three corners (%1)</source>
        <translation>某个面的角少于三个（%1）</translation>
    </message>
    <message>
        <source>the data type &apos;%1&apos; is not known</source>
        <translation>未知的数据类型“%1”</translation>
    </message>
    <message>
        <source>the file is damaged here, and none of its triangles can be read</source>
        <translation>文件在此处损坏，无法读取任何三角形</translation>
    </message>
    <message>
        <source>the file could not be written (%1)</source>
        <translation>无法写入文件（%1）</translation>
    </message>
    <message>
        <source>the archive cannot be read (%1)</source>
        <translation>无法读取压缩包（%1）</translation>
    </message>
    <message>
        <source>the part &apos;%1&apos; is missing</source>
        <translation>缺少部分“%1”</translation>
    </message>
    <message>
        <source>the part &apos;%1&apos; is damaged</source>
        <translation>部分“%1”已损坏</translation>
    </message>
    <message>
        <source>the file has version %1 of the format; this program knows up to version %2</source>
        <translation>文件格式版本为 %1；本程序最高支持版本 %2</translation>
    </message>
    <message>
        <source>the element &apos;%1&apos; is malformed: %2</source>
        <translation>元素“%1”有误：%2</translation>
    </message>
    <message>
        <source>%1 cannot be %2; it must lie between %3 and %4</source>
        <translation>%1 不能为 %2；须在 %3 与 %4 之间</translation>
    </message>
    <message>
        <source>%1 is not supported</source>
        <translation>不支持 %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>第 %1 字节</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>Close other documents or programs, or try a model with fewer triangles.</source>
        <translation>请关闭其他文档或程序，或使用三角形较少的模型。</translation>
    </message>
    <message>
        <source>Export or copy the file again.</source>
        <translation>请重新导出或复制该文件。</translation>
    </message>
    <message>
        <source>Reduce or split the model in the program that made it.</source>
        <translation>请在生成该模型的程序中简化或拆分模型。</translation>
    </message>
    <message>
        <source>Save the file as UTF-8 text or in a binary format.</source>
        <translation>请将文件保存为 UTF-8 文本或二进制格式。</translation>
    </message>
    <message>
        <source>Export the file again; its beginning is damaged or of a variant that is not supported.</source>
        <translation>请重新导出文件；其开头已损坏，或属于不支持的变体。</translation>
    </message>
    <message>
        <source>Export or copy the file again, or open only what is readable (on the command line: --partial).</source>
        <translation>请重新导出或复制文件，或只打开可读部分（命令行：--partial）。</translation>
    </message>
    <message>
        <source>Check the shape of that face, or export the model as triangles.</source>
        <translation>请检查该面的形状，或将模型导出为三角形。</translation>
    </message>
    <message>
        <source>Export the model as a surface of triangles; points and curves alone cannot be repaired.</source>
        <translation>请将模型导出为三角形曲面；仅有点和曲线无法修复。</translation>
    </message>
    <message>
        <source>Copy the file again, or go back to an earlier copy of it.</source>
        <translation>请重新复制文件，或使用较早的副本。</translation>
    </message>
    <message>
        <source>Open it with a newer version of Handwheel.</source>
        <translation>请用更新版本的 Handwheel 打开。</translation>
    </message>
    <message>
        <source>Enter a value within these limits.</source>
        <translation>请输入该范围内的值。</translation>
    </message>
    <message>
        <source>Export the model in another way or another format.</source>
        <translation>请以其他方式或其他格式导出模型。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>the plugin was made for another version of Handwheel (%1, here %2)</source>
        <translation>该插件是为另一版本的 Handwheel 制作的（%1，此处为 %2）</translation>
    </message>
    <message>
        <source>the plugin cannot be used (%1)</source>
        <translation>无法使用该插件（%1）</translation>
    </message>
    <message>
        <source>the device cannot be reached (%1)</source>
        <translation>无法连接到设备（%1）</translation>
    </message>
    <message>
        <source>Install a plugin that was made for this version, or remove the file.</source>
        <translation>请安装为此版本制作的插件，或删除该文件。</translation>
    </message>
    <message>
        <source>Switch it off and on again, or try another port.</source>
        <translation>请将其关闭后再打开，或换一个端口。</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 或 %2</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>请选择其他文件。</translation>
    </message>
    <message>
        <source>Handwheel reads files that end in %1.</source>
        <translation>Handwheel 可读取扩展名为 %1 的文件。</translation>
    </message>
    <message>
        <source>Use a name that ends in %2.</source>
        <translation>请使用以 %2 结尾的名称。</translation>
    </message>
    <message>
        <source>the step cannot be done: %1</source>
        <translation>无法执行该步骤：%1</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>请选择另一个名称。</translation>
    </message>
    <message>
        <source>Put the folder &apos;%2&apos; into &apos;%3&apos; or a folder above it, and open the file again.</source>
        <translation>请将文件夹“%2”放入“%3”或其上级文件夹，然后重新打开文件。</translation>
    </message>
    <message>
        <source>another program has changed the file since it was opened</source>
        <translation>文件打开后已被其他程序更改</translation>
    </message>
    <message>
        <source>the document has no body &apos;%1&apos;</source>
        <translation>文档中没有物体“%1”</translation>
    </message>
    <message>
        <source>the body &apos;%1&apos; is not linked to a file</source>
        <translation>物体“%1”未链接到文件</translation>
    </message>
    <message>
        <source>Only a linked body can be read again; add the file as a new one.</source>
        <translation>只有链接的物体才能重新读取；请将文件添加为新物体。</translation>
    </message>
    <message>
        <source>the linked file %1 is missing</source>
        <translation>链接的文件 %1 缺失</translation>
    </message>
    <message>
        <source>Put it back, or add the file from where it is now.</source>
        <translation>请将其放回原处，或从当前位置添加该文件。</translation>
    </message>
    <message>
        <source>Remove bodies, or add several as one file.</source>
        <translation>请移除物体，或将多个物体作为一个文件添加。</translation>
    </message>
    <message>
        <source>Reduce the mesh before adding it (&apos;handwheel decimate&apos;).</source>
        <translation>添加前请简化网格（“handwheel decimate”）。</translation>
    </message>
    <message>
        <source>the bar was cut already, so its size cannot change</source>
        <translation>棒料已被切削，尺寸不能再改变</translation>
    </message>
    <message>
        <source>Undo the passes to change the size, or begin with a new workpiece.</source>
        <translation>请撤销切削以更改尺寸，或新建工件。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the name of body %2, and the number of another</source>
        <translation>“%1”既是物体 %2 的名称，又是另一物体的编号</translation>
    </message>
    <message>
        <source>Give the name of the other body, or rename body %2.</source>
        <translation>请给出另一物体的名称，或重命名物体 %2。</translation>
    </message>
    <message>
        <source>Choose a file that you have permission to read, and check that its disk is connected.</source>
        <translation>请选择有读取权限的文件，并确认其所在磁盘已连接。</translation>
    </message>
    <message>
        <source>Check the free space and your write permission, or choose another location.</source>
        <translation>请检查可用空间和写入权限，或选择其他位置。</translation>
    </message>
    <message>
        <source>the file is inconsistent (%1: %2 expected, %3 found)</source>
        <translation>文件内容不一致（%1：应为 %2，实为 %3）</translation>
    </message>
    <message>
        <source>Correct the file at this position, or export it again.</source>
        <translation>请修正文件的此处，或重新导出。</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos; was not found in the folder &apos;%3&apos; or in those above it</source>
        <translation>在文件夹“%3”及其上级文件夹中未找到%1“%2”</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos; is referenced, but cannot be found</source>
        <translation>引用了%1“%2”，但找不到</translation>
    </message>
    <message>
        <source>Put the missing file where it is expected.</source>
        <translation>请把缺少的文件放到应在的位置。</translation>
    </message>
    <message>
        <source>the library %1 failed (%2)</source>
        <translation>库 %1 运行失败（%2）</translation>
    </message>
    <message>
        <source>this is not a file that Handwheel can read</source>
        <translation>Handwheel 无法读取此文件</translation>
    </message>
    <message>
        <source>the extension &apos;%1&apos; is not a format that this can be written in</source>
        <translation>扩展名“%1”不是此内容可写入的格式</translation>
    </message>
    <message>
        <source>the file name has no extension to specify the format</source>
        <translation>文件名没有用来指定格式的扩展名</translation>
    </message>
    <message>
        <source>Save under another name to keep both, or replace the version of the other program.</source>
        <translation>请以其他名称保存以保留两者，或替换其他程序写入的版本。</translation>
    </message>
    <message>
        <source>a body of the document is linked to this file, which would be overwritten</source>
        <translation>文档中有物体链接到此文件，写入会将其覆盖</translation>
    </message>
    <message>
        <source>Write to another file, or unlink the body first.</source>
        <translation>请写入其他文件，或先取消该物体的链接。</translation>
    </message>
    <message>
        <source>the written file did not pass verification (%1), so it was discarded</source>
        <translation>写出的文件未通过校验（%1），因此已丢弃</translation>
    </message>
    <message>
        <source>An existing file of that name was not changed. Save in another format, for example PLY.</source>
        <translation>同名的现有文件未被更改。请以其他格式保存，例如 PLY。</translation>
    </message>
    <message>
        <source>&apos;%2&apos; is not valid here</source>
        <translation>“%2”在此处无效</translation>
    </message>
    <message>
        <source>a face with %1 corners was triangulated as if it were convex</source>
        <translation>一个有 %1 个角的面已按凸多边形剖分为三角形</translation>
    </message>
    <message>
        <source>Give the name or number of an existing body; &apos;inspect&apos; lists them.</source>
        <translation>请给出现有物体的名称或编号；“inspect”会列出它们。</translation>
    </message>
    <message>
        <source>a document can contain at most %1 bodies</source>
        <translation>一个文档最多容纳 %1 个物体</translation>
    </message>
    <message>
        <source>the bodies would have %1 triangles, and a document can contain %2</source>
        <translation>这些物体将有 %1 个三角形，而文档只能容纳 %2 个</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is already in use</source>
        <translation>名称“%1”已被使用</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid name: a name is one line of 1 to %2 bytes</source>
        <translation>“%1”不是有效的名称：名称应为一行，长度 1 到 %2 字节</translation>
    </message>
    <message>
        <source>Check that it is plugged in, that no other program uses it and that you have permission to use it.</source>
        <translation>请检查设备是否已插入、没有其他程序正在使用它，以及您是否有权使用。</translation>
    </message>
    <message>
        <source>the device does not respond correctly (%1)</source>
        <translation>设备未正确响应（%1）</translation>
    </message>
    <message>
        <source>the file contains no triangles</source>
        <translation>文件中没有三角形</translation>
    </message>
    <message>
        <source>&apos;handwheel help edit&apos; lists the steps; loops are numbered as in &apos;handwheel inspect&apos;.</source>
        <translation>“handwheel help edit”列出所有步骤；边界环的编号与“handwheel inspect”相同。</translation>
    </message>
    <message>
        <source>Check the name, and whether the file was moved.</source>
        <translation>请检查文件名，或文件是否已被移动。</translation>
    </message>
    <message>
        <source>the file contains a &apos;%1&apos;, a kind of document that this program does not know</source>
        <translation>文件包含“%1”，本程序不认识这种文档类型</translation>
    </message>
    <message>
        <source>the exercise is about “%1”, which this program cannot mark</source>
        <translation>练习内容为“%1”，本程序无法对其评分</translation>
    </message>
    <message>
        <source>Open it with a newer version of the program.</source>
        <translation>请用较新版本的程序打开。</translation>
    </message>
    <message>
        <source>it was handed in for another exercise, “%1”</source>
        <translation>它是为另一练习“%1”提交的</translation>
    </message>
    <message>
        <source>Mark it with the exercise that the student&apos;s file was made from.</source>
        <translation>请用生成该学生文件的练习来评分。</translation>
    </message>
    <message>
        <source>the work does not belong to this exercise: %1</source>
        <translation>作业不属于此练习：%1</translation>
    </message>
    <message>
        <source>Begin the exercise from its file, and hand in that work.</source>
        <translation>请从练习文件开始练习，并提交该作业。</translation>
    </message>
    <message>
        <source>it has no work that was handed in</source>
        <translation>其中没有已提交的作业</translation>
    </message>
    <message>
        <source>Ask the student to hand in the exercise once more.</source>
        <translation>请让学生重新提交练习。</translation>
    </message>
    <message>
        <source>it is a student&apos;s copy, which has no marking scheme</source>
        <translation>这是学生副本，不含评分标准</translation>
    </message>
    <message>
        <source>Give the teacher&apos;s file of the exercise.</source>
        <translation>请给出练习的教师文件。</translation>
    </message>
    <message>
        <source>a student&apos;s copy of an exercise cannot be changed</source>
        <translation>练习的学生副本不能更改</translation>
    </message>
    <message>
        <source>Change the teacher&apos;s file and make students&apos; copies of it again.</source>
        <translation>请更改教师文件，然后重新生成学生副本。</translation>
    </message>
    <message>
        <source>the part has %1 closed hollows, which the file cannot contain</source>
        <translation>零件有 %1 个封闭空腔，该文件无法包含</translation>
    </message>
    <message>
        <source>Bore the part open from an end, or export triangles, for example STL.</source>
        <translation>请从一端将零件镗通，或导出三角形，例如 STL。</translation>
    </message>
    <message>
        <source>the table has no column for the %1</source>
        <translation>表格没有“%1”列</translation>
    </message>
    <message>
        <source>Its first line has to name the columns; this one may be called %2.</source>
        <translation>第一行须给出各列的名称；此列可命名为 %2。</translation>
    </message>
    <message>
        <source>the table has two columns for the %1</source>
        <translation>表格有两个“%1”列</translation>
    </message>
    <message>
        <source>Remove one of them.</source>
        <translation>请删除其中一个。</translation>
    </message>
    <message>
        <source>the table gives the spindle speed only, and no cutting speed</source>
        <translation>表格只给出主轴转速，没有切削速度</translation>
    </message>
    <message>
        <source>Say the diameter of the work (on the command line: --diameter), or add a column v in m/min.</source>
        <translation>请给出工件直径（命令行：--diameter），或添加以 m/min 为单位的 v 列。</translation>
    </message>
    <message>
        <source>there are %1 different cuts, and a model needs at least %2</source>
        <translation>有 %1 种不同的切削，而模型至少需要 %2 种</translation>
    </message>
    <message>
        <source>Add measurements at other depths, feeds and speeds, made with a sharp tool.</source>
        <translation>请补充用锋利刀具在其他切深、进给和速度下的测量数据。</translation>
    </message>
    <message>
        <source>there is no work material &apos;%1&apos;</source>
        <translation>没有工件材料“%1”</translation>
    </message>
    <message>
        <source>See the list of materials (on the command line: handwheel force --list).</source>
        <translation>请参阅材料列表（命令行：handwheel force --list）。</translation>
    </message>
    <message>
        <source>column %1, %2: %3</source>
        <translation>第 %1 列，%2：%3</translation>
    </message>
    <message>
        <source>%4 Then run the program again.</source>
        <translation>%4 然后请重新运行程序。</translation>
    </message>
    <message>
        <source>the program did not end after %1 blocks</source>
        <translation>程序在 %1 个程序段后仍未结束</translation>
    </message>
    <message>
        <source>Look for a loop whose condition never becomes false.</source>
        <translation>请检查是否有条件始终为真的循环。</translation>
    </message>
    <message>
        <source>the program stops with the alarm %1: %2</source>
        <translation>程序因报警 %1 停止：%2</translation>
    </message>
    <message>
        <source>the program stops with the alarm %1</source>
        <translation>程序因报警 %1 停止</translation>
    </message>
    <message>
        <source>A control stops here, too, before the next move. Look at the condition of the alarm.</source>
        <translation>数控系统也会在此处停止，不再执行下一个移动。请检查触发报警的条件。</translation>
    </message>
    <message>
        <source>the tool path has more than %1 moves</source>
        <translation>刀具路径超过 %1 次移动</translation>
    </message>
    <message>
        <source>Take a larger depth of cut, or divide the program.</source>
        <translation>请增大切深，或拆分程序。</translation>
    </message>
    <message>
        <source>the profile crosses the axis at Z %1 mm</source>
        <translation>轮廓在 Z %1 mm 处穿过轴线</translation>
    </message>
    <message>
        <source>Draw only the half of the section on one side of the axis.</source>
        <translation>请只绘制轴线一侧的半剖面。</translation>
    </message>
    <message>
        <source>the profile touches the axis at Z %1 mm, so the part would be in pieces</source>
        <translation>轮廓在 Z %1 mm 处与轴线接触，零件会因此分成几块</translation>
    </message>
    <message>
        <source>Import each piece from a file of its own.</source>
        <translation>请将每一块分别从单独的文件导入。</translation>
    </message>
    <message>
        <source>the profile crosses or touches itself at radius %1 mm, Z %2 mm</source>
        <translation>轮廓在半径 %1 mm、Z %2 mm 处与自身相交或接触</translation>
    </message>
    <message>
        <source>Correct the outline there: it must enclose one area.</source>
        <translation>请修正该处的轮廓线：它必须围成一个区域。</translation>
    </message>
    <message>
        <source>the profile has a gap of %1 mm at radius %2 mm, Z %3 mm</source>
        <translation>轮廓在半径 %2 mm、Z %3 mm 处有 %1 mm 的间隙</translation>
    </message>
    <message>
        <source>Join the ends of the lines there.</source>
        <translation>请连接该处的线端。</translation>
    </message>
    <message>
        <source>the profile encloses no material</source>
        <translation>轮廓未围成任何材料</translation>
    </message>
    <message>
        <source>Draw the outline of the half section, from one end of the part to the other.</source>
        <translation>请绘制从零件一端到另一端的半剖面轮廓线。</translation>
    </message>
    <message>
        <source>the file contains no profile</source>
        <translation>文件不含轮廓</translation>
    </message>
    <message>
        <source>Draw the half section with visible lines, arcs or polylines, outside of blocks.</source>
        <translation>请在块以外用可见的直线、圆弧或多段线绘制半剖面。</translation>
    </message>
    <message>
        <source>Remove frames, dimensions and other views, or join the ends of the lines.</source>
        <translation>请移除图框、尺寸标注和其他视图，或连接线端。</translation>
    </message>
    <message>
        <source>it is a binary DXF file, and only those in text can be read</source>
        <translation>这是二进制 DXF 文件，只能读取文本格式的 DXF</translation>
    </message>
    <message>
        <source>Save it as ASCII DXF.</source>
        <translation>请将其另存为 ASCII DXF。</translation>
    </message>
    <message>
        <source>the drawing does not show where the axis is</source>
        <translation>图中未标明轴线的位置</translation>
    </message>
    <message>
        <source>Draw the axis as a horizontal line with the id or layer &apos;axis&apos;.</source>
        <translation>请将轴线绘制为水平线，其 id 或图层为“axis”。</translation>
    </message>
    <message>
        <source>the solid has no axis of revolution</source>
        <translation>实体没有回转轴</translation>
    </message>
    <message>
        <source>Choose a part that can be turned.</source>
        <translation>请选择可车削的零件。</translation>
    </message>
    <message>
        <source>it is not a turned part: face %1, a %2 at (%3, %4, %5), does not turn about its axis</source>
        <translation>这不是车削件：第 %1 个面（%2，位于 (%3, %4, %5)）不是绕其轴线的回转面</translation>
    </message>
    <message>
        <source>Remove that feature, or choose to ignore what is not turned.</source>
        <translation>请移除该特征，或选择忽略非回转的部分。</translation>
    </message>
    <message>
        <source>Save the turned part alone in a file.</source>
        <translation>请将车削件单独保存到一个文件中。</translation>
    </message>
    <message>
        <source>nothing was cut yet, so there are no passes to write</source>
        <translation>尚未切削，因此没有可写入的走刀</translation>
    </message>
    <message>
        <source>Cut the part by hand first, or make cycles for a target.</source>
        <translation>请先手动切削零件，或针对目标生成循环。</translation>
    </message>
    <message>
        <source>the cycles collide in line %1</source>
        <translation>循环在第 %1 行发生碰撞</translation>
    </message>
    <message>
        <source>Take a smaller nose or depth of cut.</source>
        <translation>请减小刀尖圆弧半径或切深。</translation>
    </message>
    <message>
        <source>the cycles cut %1 mm into the target at Z %2</source>
        <translation>循环在 Z %2 处切入目标 %1 mm</translation>
    </message>
    <message>
        <source>Take a smaller nose.</source>
        <translation>请减小刀尖圆弧半径。</translation>
    </message>
    <message>
        <source>Draw it with fewer lines, for example without hatching.</source>
        <translation>请用较少的线条绘制，例如不画剖面线。</translation>
    </message>
    <message>
        <source>it is not a turned part: points are %1 mm off circles about an axis, %2 mm is allowed</source>
        <translation>它不是车削零件：点偏离绕轴的圆 %1 mm，允许 %2 mm</translation>
    </message>
    <message>
        <source>Export the part as STEP, or as a finer mesh without other features.</source>
        <translation>请将零件导出为 STEP，或导出为没有其他特征的更细网格。</translation>
    </message>
    <message>
        <source>the exercise has no target, so there is nothing to draw</source>
        <translation>练习没有目标，因此没有可绘制的内容</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a path of the cell nor a file</source>
        <translation>“%1”既不是单元中的路径，也不是文件</translation>
    </message>
    <message>
        <source>Name a path of the cell (&apos;inspect&apos; lists them), or a file with one.</source>
        <translation>请指定单元中的路径（用 inspect 列出），或包含路径的文件。</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; has fewer than two places</source>
        <translation>路径“%1”少于两个位置</translation>
    </message>
    <message>
        <source>Add the places that the robot is to move to.</source>
        <translation>请添加机器人要到达的位置。</translation>
    </message>
    <message>
        <source>at %1 the robot collides: %2 with %3</source>
        <translation>在 %1 处机器人发生碰撞：%2 与 %3</translation>
    </message>
    <message>
        <source>at %1 the joint %2 is beyond its limits</source>
        <translation>在 %1 处，关节 %2 超出限位</translation>
    </message>
    <message>
        <source>Give joint values within the limits.</source>
        <translation>请给出限位内的关节值。</translation>
    </message>
    <message>
        <source>no path from %1 to %2 was found in %3 s</source>
        <translation>在 %3 秒内未找到从 %1 到 %2 的路径</translation>
    </message>
    <message>
        <source>Allow more time, or insert a critical configuration in between.</source>
        <translation>请给予更多时间，或在中间插入一个关键位形。</translation>
    </message>
    <message>
        <source>at %1 a joint beside the arm, such as a finger, has another value</source>
        <translation>在 %1 处，机械臂之外的关节（如手指）的值不同</translation>
    </message>
    <message>
        <source>Only the joints between base and tool are planned; the others must stay.</source>
        <translation>只规划基座与工具之间的关节；其余关节必须保持不动。</translation>
    </message>
    <message>
        <source>the arm cannot follow the straight line to %1: it stops after %2 %</source>
        <translation>机械臂无法沿直线到达 %1：在 %2 % 处停止</translation>
    </message>
    <message>
        <source>the robot cannot reach where motion %1 ends</source>
        <translation>机器人无法到达运动 %1 的终点</translation>
    </message>
    <message>
        <source>Check that the program is for this robot, its tool and its frame.</source>
        <translation>请检查程序是否适用于此机器人、其工具和坐标系。</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; collides in %2 places, first %3 with %4</source>
        <translation>路径“%1”在 %2 处碰撞，首先是 %3 与 %4</translation>
    </message>
    <message>
        <source>Plan it again, or see all of them with &apos;verify&apos;.</source>
        <translation>请重新规划，或用 verify 查看全部。</translation>
    </message>
    <message>
        <source>%1 programs move %2 joints, and this arm has %3</source>
        <translation>%1 程序控制 %2 个关节，而该机械臂有 %3 个</translation>
    </message>
    <message>
        <source>Write the path as CSV or JSON.</source>
        <translation>请将路径写为 CSV 或 JSON。</translation>
    </message>
    <message>
        <source>the path has %1 motions, and a program can have %2</source>
        <translation>路径有 %1 个运动，而程序最多 %2 个</translation>
    </message>
    <message>
        <source>Divide the path.</source>
        <translation>请拆分路径。</translation>
    </message>
    <message>
        <source>motion %1 has a value that is not a number</source>
        <translation>运动 %1 含有非数值</translation>
    </message>
    <message>
        <source>Plan the path again.</source>
        <translation>请重新规划路径。</translation>
    </message>
    <message>
        <source>the robot carries &apos;%1&apos;, so its tool cannot work on it</source>
        <translation>机器人正携带“%1”，其工具无法加工它</translation>
    </message>
    <message>
        <source>Choose a part that stands in the cell, or take it off the robot.</source>
        <translation>请选择立于单元中的零件，或将其从机器人上取下。</translation>
    </message>
    <message>
        <source>no such curve was found on &apos;%1&apos;</source>
        <translation>在“%1”上未找到这样的曲线</translation>
    </message>
    <message>
        <source>Choose a place on a sharp edge of the part, or a section through it.</source>
        <translation>请选择零件锐边上的一点，或穿过零件的截面。</translation>
    </message>
    <message>
        <source>Move the part nearer, turn the tool, or let it turn about its own axis.</source>
        <translation>请将零件移近、转动工具，或允许工具绕自身轴线转动。</translation>
    </message>
    <message>
        <source>Divide the curve, turn the tool, or let it turn about its own axis.</source>
        <translation>请拆分曲线、转动工具，或允许工具绕自身轴线转动。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a configuration or target of the cell nor a value for each joint</source>
        <translation>“%1”既不是单元中的位形或目标点，也不是每个关节一个的数值</translation>
    </message>
    <message>
        <source>Name a configuration or a target, or give the joint values in radians (&apos;0 0.5 -1 …&apos;).</source>
        <translation>请指定一个位形或目标点，或以弧度给出各关节值（“0 0.5 -1 …”）。</translation>
    </message>
    <message>
        <source>Name a file of one of these kinds, or a robot as irb120 or ur5.</source>
        <translation>请指定上述类型之一的文件，或机器人名称，如 irb120 或 ur5。</translation>
    </message>
    <message>
        <source>the cell already has a configuration or a target called &apos;%1&apos;</source>
        <translation>单元中已有名为“%1”的位形或目标点</translation>
    </message>
    <message>
        <source>the body that the target &apos;%1&apos; is on was removed</source>
        <translation>目标点“%1”所在的物体已被移除</translation>
    </message>
    <message>
        <source>Undo that, or remove the target.</source>
        <translation>请撤销该操作，或移除该目标点。</translation>
    </message>
    <message>
        <source>Choose a nearer place, or turn the tool.</source>
        <translation>请选择较近的位置，或转动工具。</translation>
    </message>
    <message>
        <source>Choose another place, or turn the tool.</source>
        <translation>请选择其他位置，或转动工具。</translation>
    </message>
    <message>
        <source>Choose another place, turn the tool, or require less clearance.</source>
        <translation>请选择其他位置，转动工具，或减小所需间隙。</translation>
    </message>
    <message>
        <source>the bar is that of the exercise, so it cannot change</source>
        <translation>棒料由练习规定，因此不能更改</translation>
    </message>
    <message>
        <source>Work with this bar. The teacher changes it in the file of the exercise.</source>
        <translation>请使用此棒料。教师可在练习文件中更改它。</translation>
    </message>
    <message>
        <source>the %2 of motion %1 is %4 in the program, and %3 in the path</source>
        <translation>运动 %1 的 %2 在程序中为 %4，在路径中为 %3</translation>
    </message>
    <message>
        <source>Report this to the author of the post-processor; the program was not written.</source>
        <translation>请向后处理器的作者报告此问题；程序未写入。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a URDF, a table after Denavit and Hartenberg, a robot cell nor a built-in robot</source>
        <translation>“%1”既不是 URDF、Denavit-Hartenberg 表、机器人单元，也不是内置机器人</translation>
    </message>
    <message>
        <source>on the straight line to %1 the robot collides: %2 with %3</source>
        <translation>在到 %1 的直线上机器人发生碰撞：%2 与 %3</translation>
    </message>
    <message>
        <source>Remove what is not needed any more, or plan it in another cell.</source>
        <translation>请移除不再需要的内容，或在另一个单元中规划。</translation>
    </message>
    <message>
        <source>the cell has no robot called &apos;%1&apos;</source>
        <translation>单元中没有名为“%1”的机器人</translation>
    </message>
    <message>
        <source>Name one of its robots (&apos;inspect&apos; lists them).</source>
        <translation>请指定单元中的一个机器人（用 inspect 列出）。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be the name of a robot</source>
        <translation>“%1”不能用作机器人的名称</translation>
    </message>
    <message>
        <source>Choose another name, of one line.</source>
        <translation>请选择另一个名称，且只能为一行。</translation>
    </message>
    <message>
        <source>%1 is the only robot of the cell, which must have one</source>
        <translation>%1 是单元中唯一的机器人，而单元必须有一个机器人</translation>
    </message>
    <message>
        <source>Add another robot before this one is removed.</source>
        <translation>请先添加另一个机器人，再移除它。</translation>
    </message>
    <message>
        <source>Move the other robots and the bodies instead.</source>
        <translation>请改为移动其他机器人和物体。</translation>
    </message>
    <message>
        <source>Choose that robot first; on the command line: --arm.</source>
        <translation>请先选择那个机器人；命令行：--arm。</translation>
    </message>
    <message>
        <source>Give this field of the exercise another value.</source>
        <translation>请为练习的此字段指定其他值。</translation>
    </message>
    <message>
        <source>In a copy of the program, replace it by the motions that it leads to, or remove it.</source>
        <translation>请在程序的副本中用它所产生的运动替换它，或将其删除。</translation>
    </message>
    <message>
        <source>voxels of %1 mm are too fine for a part of %2 mm</source>
        <translation>%1 mm 的体素对于 %2 mm 的零件过细</translation>
    </message>
    <message>
        <source>Choose voxels of at least %3 mm.</source>
        <translation>请选择不小于 %3 mm 的体素。</translation>
    </message>
    <message>
        <source>Choose larger voxels, or close other programs.</source>
        <translation>请选择更大的体素，或关闭其他程序。</translation>
    </message>
    <message>
        <source>Choose larger voxels, or work on a piece of the part.</source>
        <translation>请选择更大的体素，或只处理零件的一部分。</translation>
    </message>
    <message>
        <source>Choose smaller voxels.</source>
        <translation>请选择更小的体素。</translation>
    </message>
    <message>
        <source>Import a target, or turn a model solution and take it as the target.</source>
        <translation>请导入目标，或车削一个参考答案并将其设为目标。</translation>
    </message>
    <message>
        <source>Turn the part first, or import the target from a drawing.</source>
        <translation>请先车削零件，或从图纸导入目标。</translation>
    </message>
    <message>
        <source>%1: there is no mark “%2”</source>
        <translation>%1：没有评分项“%2”</translation>
    </message>
    <message>
        <source>Put “;” between the names of several marks. There are: %3.</source>
        <translation>多个评分项的名称之间请用“;”分隔。现有：%3。</translation>
    </message>
    <message>
        <source>Add what is marked in “Criteria” first.</source>
        <translation>请先在“评分项”中添加要评分的内容。</translation>
    </message>
    <message>
        <source>there is no drill “%1”</source>
        <translation>没有钻头“%1”</translation>
    </message>
    <message>
        <source>there is no material “%1” to be drilled</source>
        <translation>没有可钻削的材料“%1”</translation>
    </message>
    <message>
        <source>&apos;handwheel help drill&apos; lists the materials.</source>
        <translation>“handwheel help drill”列出所有材料。</translation>
    </message>
    <message>
        <source>Choose another range; bone in a CT begins at about 300.</source>
        <translation>请选择其他范围；CT 中骨骼约从 300 开始。</translation>
    </message>
    <message>
        <source>Use a joint motion, or choose the same configuration at both ends.</source>
        <translation>请使用关节运动，或在两端选择相同的位形。</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; leads along the curve where &apos;%2&apos; was when it was planned</source>
        <translation>路径“%1”沿规划时“%2”所在位置的曲线</translation>
    </message>
    <message>
        <source>Plan it again, or write it as it is; on the command line: --outdated.</source>
        <translation>请重新规划，或按原样写入；命令行：--outdated。</translation>
    </message>
    <message>
        <source>places %1 and %2 of the curve are not connected by the surface</source>
        <translation>曲线的位置 %1 与 %2 未通过曲面相连</translation>
    </message>
    <message>
        <source>Draw around the gap, or place more points.</source>
        <translation>请绕过间隙绘制，或放置更多的点。</translation>
    </message>
    <message>
        <source>the cell would have %2 %1, and it can contain %3</source>
        <translation>单元将有 %2 个%1，而最多只能容纳 %3 个</translation>
    </message>
    <message>
        <source>the base of %1 is the origin of the cell</source>
        <translation>%1 的基座是单元的原点</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to another robot than the one to plan for: %2</source>
        <translation>“%1”属于另一个机器人 %2，而非当前规划的机器人</translation>
    </message>
    <message>
        <source>the exercise does not specify its subject</source>
        <translation>练习未指定其内容</translation>
    </message>
    <message>
        <source>nothing was turned in this work; it is the bar itself</source>
        <translation>此作业中没有车削任何内容；它仍是原棒料</translation>
    </message>
    <message>
        <source>nothing was drilled in this work</source>
        <translation>此作业中没有钻任何孔</translation>
    </message>
    <message>
        <source>Drill the hole first; it becomes the planned path.</source>
        <translation>请先钻孔；该孔将成为规划路径。</translation>
    </message>
    <message>
        <source>the file contains %1 separate outlines, and a profile is a single one</source>
        <translation>文件含 %1 条独立的轮廓线，而轮廓只能有一条</translation>
    </message>
    <message>
        <source>the outline has too many reversals to be checked</source>
        <translation>轮廓线的反向次数过多，无法检查</translation>
    </message>
    <message>
        <source>the file contains %1 solids, and a target is a single one</source>
        <translation>文件含 %1 个实体，而目标只能有一个</translation>
    </message>
    <message>
        <source>joint %2 of the arm is prismatic, which %1 programs do not support</source>
        <translation>机械臂的关节 %2 是移动关节，%1 程序不支持</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not supported, and may change where or whether the robot moves</source>
        <translation>“%1”不受支持，而它可能影响机器人是否移动以及移动到何处</translation>
    </message>
    <message>
        <source>motion %1 is a line at %2 mm/s, and %3 controllers accept at most %4 mm/s</source>
        <translation>运动 %1 是速度为 %2 mm/s 的直线，而 %3 控制器最高只接受 %4 mm/s</translation>
    </message>
    <message>
        <source>Lower the speed of the place at its end.</source>
        <translation>请降低该运动终点位置的速度。</translation>
    </message>
    <message>
        <source>voxels of %1 mm would need %2 MB, and %3 MB are available</source>
        <translation>%1 mm 的体素需要 %2 MB，而可用内存为 %3 MB</translation>
    </message>
    <message>
        <source>voxels of %1 mm make a volume of %2 MB, and a document can contain %3 MB</source>
        <translation>边长 %1 mm 的体素会得到 %2 MB 的体素模型，而一个文档最多容纳 %3 MB</translation>
    </message>
    <message>
        <source>an image of %1 MB with %2 MB of voxels is too large: %3 MB is the most</source>
        <translation>%1 MB 的图像加上 %2 MB 的体素过大：最多 %3 MB</translation>
    </message>
    <message>
        <source>Choose larger voxels; &apos;handwheel segment&apos; keeps no image.</source>
        <translation>请选择更大的体素；“handwheel segment”不保留图像。</translation>
    </message>
    <message>
        <source>no voxel of %1 mm lies inside the part, which is thinner than that</source>
        <translation>没有边长 %1 mm 的体素位于零件内部：零件比体素还薄</translation>
    </message>
    <message>
        <source>the surface encloses no volume</source>
        <translation>曲面未围成任何体积</translation>
    </message>
    <message>
        <source>nothing is left of the material</source>
        <translation>没有剩余材料</translation>
    </message>
    <message>
        <source>Check where the bodies are, or choose a smaller distance.</source>
        <translation>请检查物体的位置，或选择更小的距离。</translation>
    </message>
    <message>
        <source>a wall of %1 mm is thinner than two voxels of %2 mm</source>
        <translation>%1 mm 的壁比两个 %2 mm 的体素还薄</translation>
    </message>
    <message>
        <source>Choose a thicker wall, or voxels of at most %3 mm.</source>
        <translation>请选择更厚的壁，或不大于 %3 mm 的体素。</translation>
    </message>
    <message>
        <source>Choose a lower rate, or a part of the path.</source>
        <translation>请选择较低的频率，或只取路径的一部分。</translation>
    </message>
    <message>
        <source>no sample has a value from %1 to %2: the values of the image range from %3 to %4</source>
        <translation>没有采样点的值在 %1 至 %2 之间：图像的值为 %3 至 %4</translation>
    </message>
    <message>
        <source>Turn its faces outwards, or make walls of sheets: &apos;handwheel voxelize --wall MM&apos;.</source>
        <translation>请使其各面朝外，或将片体做成壁：“handwheel voxelize --wall MM”。</translation>
    </message>
    <message>
        <source>“%1” has no meaning for a drilling program here</source>
        <translation>“%1”在此处的钻孔程序中没有意义</translation>
    </message>
    <message>
        <source>Drill by G0, G1, G81, G82, G83, G80, G98, G99 and G4, in millimetres and absolute.</source>
        <translation>请使用 G0、G1、G81、G82、G83、G80、G98、G99 和 G4 钻孔，以毫米为单位并采用绝对坐标。</translation>
    </message>
    <message>
        <source>%1 is missing, which %2 needs</source>
        <translation>缺少 %2 所需的 %1</translation>
    </message>
    <message>
        <source>%1 has a value that it cannot have (%2)</source>
        <translation>%1 的值不允许（%2）</translation>
    </message>
    <message>
        <source>the program has more than %1 moves</source>
        <translation>程序超过 %1 次移动</translation>
    </message>
    <message>
        <source>Choose larger pecks, or a part of the program.</source>
        <translation>请选择更大的啄钻深度，或只用程序的一部分。</translation>
    </message>
    <message>
        <source>the program moves nothing</source>
        <translation>程序没有任何移动</translation>
    </message>
    <message>
        <source>It begins with a move of all three axes, such as G0 X0 Y0 Z10.</source>
        <translation>程序以三个轴同时移动开始，例如 G0 X0 Y0 Z10。</translation>
    </message>
    <message>
        <source>the picture of format %1 is damaged, or not one that can be read</source>
        <translation>格式为 %1 的图片已损坏或无法读取</translation>
    </message>
    <message>
        <source>nothing stands out in it: all is black, or of one height</source>
        <translation>其中没有任何凸起：全是黑色或高度相同</translation>
    </message>
    <message>
        <source>Choose a picture with bright places, or a shape that rises along z.</source>
        <translation>请选择有明亮部位的图片，或沿 z 方向凸起的形状。</translation>
    </message>
    <message>
        <source>Write passes of tools that turn, bore or drill.</source>
        <translation>请写入车削、镗孔或钻孔刀具的走刀。</translation>
    </message>
    <message>
        <source>voxels of %1 mm would need %2 MB, which is more than a quarter of the %3 MB that are available</source>
        <translation>%1 mm 的体素需要 %2 MB，超过可用内存 %3 MB 的四分之一</translation>
    </message>
    <message>
        <source>Choose larger voxels, or confirm it with --yes.</source>
        <translation>请选择更大的体素，或用 --yes 确认。</translation>
    </message>
    <message>
        <source>voxels of %1 mm would keep %2 % of the surface, and at least %3 % are needed</source>
        <translation>%1 mm 的体素只能保留 %2 % 的表面，至少需要 %3 %</translation>
    </message>
    <message>
        <source>Walls thinner than a voxel are lost: choose smaller voxels, or a wall thickness.</source>
        <translation>比体素薄的壁会丢失：请选择更小的体素，或设定壁厚。</translation>
    </message>
    <message>
        <source>Walls thinner than a voxel are lost: choose smaller voxels.</source>
        <translation>比体素薄的壁会丢失：请选择更小的体素。</translation>
    </message>
    <message>
        <source>Write ball, burr, twist or saw with a diameter from 0.05 to 200 mm, such as ball:6.</source>
        <translation>请写 ball、burr、twist 或 saw，并给出 0.05 至 200 mm 的直径，例如 ball:6。</translation>
    </message>
    <message>
        <source>voxels of %1 mm would contain %2 mm³, and at least %3 mm³ are needed</source>
        <translation>%1 mm 的体素只包含 %2 mm³，至少需要 %3 mm³</translation>
    </message>
    <message>
        <source>the cell has no frame called &apos;%1&apos;</source>
        <translation>单元中没有名为“%1”的坐标系</translation>
    </message>
    <message>
        <source>Name one of its frames (&apos;inspect&apos; lists them).</source>
        <translation>请指定其中一个坐标系（“inspect”会列出它们）。</translation>
    </message>
    <message>
        <source>what carries the frame &apos;%1&apos; was removed</source>
        <translation>坐标系“%1”的载体已被移除</translation>
    </message>
    <message>
        <source>Undo that, or set the frame anew.</source>
        <translation>请撤销该操作，或重新设置坐标系。</translation>
    </message>
    <message>
        <source>the robot moves the frame &apos;%1&apos;, so that no program can be written in it</source>
        <translation>机器人会移动坐标系“%1”，因此无法在其中编写程序</translation>
    </message>
    <message>
        <source>Choose a frame that stands still while the robot moves.</source>
        <translation>请选择机器人运动时静止不动的坐标系。</translation>
    </message>
    <message>
        <source>the path takes %1 s, and at most %2 s can be followed at this rate</source>
        <translation>路径需要 %1 秒，而在此频率下最多只能跟随 %2 秒</translation>
    </message>
    <message>
        <source>a tool with a radius of %1 mm does not suit voxels of %2 mm: from %3 to %4 mm it does</source>
        <translation>半径为 %1 mm 的工具不适合 %2 mm 的体素：%3 至 %4 mm 才适合</translation>
    </message>
    <message>
        <source>Choose another radius, or other voxels.</source>
        <translation>请选择其他半径或其他体素。</translation>
    </message>
    <message>
        <source>the strokes go %1 mm, and a tool with a radius of %2 mm can be led %3 mm at most</source>
        <translation>笔划长 %1 mm，而半径为 %2 mm 的工具最多只能移动 %3 mm</translation>
    </message>
    <message>
        <source>Check the unit of the places, or divide the strokes.</source>
        <translation>请检查位置的单位，或拆分笔划。</translation>
    </message>
    <message>
        <source>the layer “%1” takes no strokes, as it is off, or its strength is below 1</source>
        <translation>图层“%1”不接受笔画，因为它已关闭或强度小于 1</translation>
    </message>
    <message>
        <source>Turn it on with a strength of 1, or add a layer above it.</source>
        <translation>请以强度 1 打开它，或在其上添加一个图层。</translation>
    </message>
    <message>
        <source>the layer “%1” takes no strokes, as the layer “%2” is above it</source>
        <translation>图层“%1”不接受笔画，因为图层“%2”在其上方</translation>
    </message>
    <message>
        <source>Merge the layers above it, or name a new layer.</source>
        <translation>请合并其上方的图层，或指定一个新图层。</translation>
    </message>
    <message>
        <source>a volume has at most %1 layers</source>
        <translation>一个体积最多有 %1 个图层</translation>
    </message>
    <message>
        <source>Merge some of them first.</source>
        <translation>请先合并其中一些。</translation>
    </message>
    <message>
        <source>the curve of the path &apos;%1&apos; was planned with another tool centre point</source>
        <translation>路径“%1”的曲线是用另一个工具中心点规划的</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; leads to where the target &apos;%2&apos; was when it was planned</source>
        <translation>路径“%1”通向规划时目标“%2”所在的位置</translation>
    </message>
    <message>
        <source>the file is open in another tab, and would be replaced</source>
        <translation>该文件已在另一个标签页中打开，将被替换</translation>
    </message>
    <message>
        <source>Choose another name, or close the other tab first.</source>
        <translation>请选择其他名称，或先关闭另一个标签页。</translation>
    </message>
    <message>
        <source>the robot stood elsewhere when the curve of the path &apos;%1&apos; was planned</source>
        <translation>规划路径“%1”的曲线时机器人在别处</translation>
    </message>
    <message>
        <source>Move the robot away there, or let two bodies touch that are meant to.</source>
        <translation>请将机器人移离该处，或允许本应接触的两个物体接触。</translation>
    </message>
    <message>
        <source>at %1 the robot is too near: %2 is %4 mm from %3</source>
        <translation>在 %1 处机器人过近：%2 距 %3 %4 毫米</translation>
    </message>
    <message>
        <source>Move the robot away there, or require less clearance.</source>
        <translation>请将机器人移离该处，或减小要求的间隙。</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; leads to &apos;%2&apos; as that was stored when it was planned</source>
        <translation>路径“%1”通向规划时所存的“%2”</translation>
    </message>
    <message>
        <source>Use a joint motion, change either place, or let bodies touch that are meant to.</source>
        <translation>请改用关节运动，更改其中一个位置，或允许本应接触的物体接触。</translation>
    </message>
    <message>
        <source>on the straight line to %1 the robot is too near: %2 is %4 mm from %3</source>
        <translation>在通往 %1 的直线上机器人过近：%2 距 %3 %4 毫米</translation>
    </message>
    <message>
        <source>Use a joint motion, change this place or the one before, or require less clearance.</source>
        <translation>请改用关节运动，更改此位置或前一位置，或减小要求的间隙。</translation>
    </message>
    <message>
        <source>Tilt the tool away, keep a distance or less clearance, or let it touch the part.</source>
        <translation>请将刀具倾斜避让、保持距离或减小间隙，或允许它接触零件。</translation>
    </message>
    <message>
        <source>the pose is in the base of the controller, which the description of %1 does not have</source>
        <translation>该位姿以控制器的基座为准，而 %1 的描述中没有该基座</translation>
    </message>
    <message>
        <source>Use the built-in robot, add a link &apos;base&apos; to the description, or give the motions joint values.</source>
        <translation>请使用内置机器人，在描述中添加连杆“base”，或为运动给出关节值。</translation>
    </message>
    <message>
        <source>the robot cannot reach point %1 of %2 of the curve, at X %3 Y %4 Z %5 mm in the cell</source>
        <translation>机器人无法到达曲线的第 %1 个点（共 %2 个），位于单元坐标 X %3 Y %4 Z %5 mm 处</translation>
    </message>
    <message>
        <source>at point %1 of %2 of the curve, X %3 Y %4 Z %5 mm in the cell, the robot collides: %6 with %7</source>
        <translation>在曲线的第 %1 个点（共 %2 个），单元坐标 X %3 Y %4 Z %5 mm 处，机器人发生碰撞：%6 与 %7</translation>
    </message>
    <message>
        <source>the arm cannot follow the curve to point %1 of %2, X %3 Y %4 Z %5 mm in the cell, without a jump of a joint</source>
        <translation>手臂无法在关节不跳变的情况下沿曲线到达第 %1 个点（共 %2 个），单元坐标 X %3 Y %4 Z %5 mm 处</translation>
    </message>
    <message>
        <source>the arm cannot bring its tool to X %1 Y %2 Z %3 mm in the cell in this orientation</source>
        <translation>手臂无法以此姿态将工具移到单元坐标 X %1 Y %2 Z %3 mm 处</translation>
    </message>
    <message>
        <source>to bring the tool to X %1 Y %2 Z %3 mm in the cell in this orientation, joint %4 would exceed its limits</source>
        <translation>要以此姿态将工具移到单元坐标 X %1 Y %2 Z %3 mm 处，关节 %4 将超出其限位</translation>
    </message>
    <message>
        <source>with its tool at X %1 Y %2 Z %3 mm in the cell the robot collides in every configuration: %4 with %5</source>
        <translation>工具位于单元坐标 X %1 Y %2 Z %3 mm 处时，机器人在每种构型下都会碰撞：%4 与 %5</translation>
    </message>
    <message>
        <source>along the line the arm does not come to its end with configuration %1, and controllers stop</source>
        <translation>沿该直线手臂不会以构型 %1 到达终点，控制器会停止</translation>
    </message>
    <message>
        <source>In a copy of the program, correct the configuration, or write ConfL\Off before the line.</source>
        <translation>请在程序的副本中更正构型，或在该行之前写入 ConfL\Off。</translation>
    </message>
    <message>
        <source>the folder contains no DICOM files</source>
        <translation>文件夹中没有 DICOM 文件</translation>
    </message>
    <message>
        <source>Choose a file, or the folder in which the slices are; folders in it are not searched.</source>
        <translation>请选择一个文件，或切片所在的文件夹；不会搜索其中的子文件夹。</translation>
    </message>
    <message>
        <source>all passes were made with a file, paper or a disk, or are threads that no program can cut</source>
        <translation>所有走刀都是用锉刀、砂纸或砂轮完成的，或是程序无法切削的螺纹</translation>
    </message>
    <message>
        <source>%2: %3</source>
        <translation>%2：%3</translation>
    </message>
    <message>
        <source>%4 Then make the program again.</source>
        <translation>%4 然后请重新生成程序。</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; is not proven free: the shape of %2 (%3) could not be read</source>
        <translation>路径“%1”未被证明无碰撞：无法读取%2的形状（%3）</translation>
    </message>
    <message>
        <source>Replace it by a body that the link carries, or leave it out of proofs, in the panel Cell or by &apos;handwheel set CELL missing.LINK=…&apos;.</source>
        <translation>请用该连杆携带的物体代替它，或在证明中略去它：在“单元”面板中，或用“handwheel set CELL missing.LINK=…”。</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; is not proven: CNT rounds the corner at place %2, and not everything within the corner is free</source>
        <translation>路径“%1”未得到证明：CNT 在位置 %2 处使拐角变圆，而拐角内并非全部无碰撞</translation>
    </message>
    <message>
        <source>Set its rounding to 0 (FINE), or change the places; on the command line: --cnt-as-fine.</source>
        <translation>将其圆滑值设为 0（FINE），或更改位置；在命令行中：--cnt-as-fine。</translation>
    </message>
    <message>
        <source>the proof of the path &apos;%1&apos; ends at place %2: &apos;%3&apos; may grip or release something</source>
        <translation>路径“%1”的证明在位置 %2 处终止：“%3”可能抓取或释放物体</translation>
    </message>
    <message>
        <source>Say at that place that the robot carries the same as before; on the command line: --carried same.</source>
        <translation>在该位置指明机器人携带的物体与之前相同；在命令行中：--carried same。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a line of %3, and %2 programs cannot have it (lines: %4)</source>
        <translation>“%1”是 %3 的语句，%2 程序中不能有它（行：%4）</translation>
    </message>
    <message>
        <source>Write the program in its own language, or without these lines; on the command line: --without-io.</source>
        <translation>用其自身的语言写出程序，或不带这些行；在命令行中：--without-io。</translation>
    </message>
    <message>
        <source>motion %1 ends with the rounding CNT, which %2 programs do not have</source>
        <translation>运动 %1 以圆滑过渡 CNT 结束，而 %2 程序没有该功能</translation>
    </message>
    <message>
        <source>Set the rounding of the place to 0 (FINE), and a blend if need be; on the command line: --cnt-as-fine.</source>
        <translation>将该位置的圆滑值设为 0（FINE），必要时设置过渡；在命令行中：--cnt-as-fine。</translation>
    </message>
    <message>
        <source>Use the built-in robot irb2400, or write the path as CSV or JSON.</source>
        <translation>请使用内置机器人 irb2400，或将路径写为 CSV 或 JSON。</translation>
    </message>
    <message>
        <source>Move joints 2 and 3 at that place, and verify the path again.</source>
        <translation>请调整该处的关节 2 和 3，然后重新验证路径。</translation>
    </message>
    <message>
        <source>the description of %1 lacks its parallel linkage, which %2 counts with</source>
        <translation>%1的描述缺少平行连杆机构，而%2按该机构计数</translation>
    </message>
    <message>
        <source>motion %1 ends with axis 3 at %2° from the level, beyond %3° to %4°</source>
        <translation>运动%1结束时，轴3相对水平面为%2°，超出%3°至%4°</translation>
    </message>
    <message>
        <source>the motion turns joint %1 by %2°, and the description of the robot has no limits for it, so that paths turn it the shorter way</source>
        <translation>该运动将关节 %1 转动 %2°，而机器人描述中没有其限位，因此路径按较短方向转动它</translation>
    </message>
    <message>
        <source>Give the joint its limits in the description, or divide the motion.</source>
        <translation>请在描述中给出该关节的限位，或将运动分段。</translation>
    </message>
    <message>
        <source>the controller moves %1 %2 %3, which is %4° there, from %5° to %6° only</source>
        <translation>控制器只让 %1 %2 %3 在 %5° 到 %6° 之间运动，而此处为 %4°</translation>
    </message>
    <message>
        <source>Check that the program is for this robot, and change the joints there.</source>
        <translation>请检查该程序是否用于此机器人，并修改该处的关节值。</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; leads to where the frame &apos;%2&apos; was when its program was opened</source>
        <translation>路径“%1”通向打开其程序时坐标系“%2”所在的位置</translation>
    </message>
    <message>
        <source>Open the program again or plan the path again, or write it as it is; on the command line: --outdated.</source>
        <translation>请重新打开程序或重新规划路径，或按现状写出；在命令行中：--outdated。</translation>
    </message>
    <message>
        <source>the robot does not reach this place in the configuration that the program gives</source>
        <translation>机器人无法以程序给出的构型到达此处</translation>
    </message>
    <message>
        <source>Check that the program is for this robot, its tool and its frame, or correct the configuration in a copy of the program.</source>
        <translation>请检查该程序是否用于此机器人、其工具和坐标系，或在程序副本中更正构型。</translation>
    </message>
    <message>
        <source>the tool or frame of this place is on the controller, not in the file, or it moves</source>
        <translation>此处的工具或坐标系在控制器上而不在文件中，或者它会移动</translation>
    </message>
    <message>
        <source>Add its data to a copy of the program, or create a frame of that name in the cell.</source>
        <translation>请在程序副本中加入其数据，或在单元中创建同名坐标系。</translation>
    </message>
    <message>
        <source>the place is the result of the function %1, which is not supported</source>
        <translation>该位置是函数 %1 的结果，不支持此函数</translation>
    </message>
    <message>
        <source>In a copy of the program, replace it by the numbers that it returns.</source>
        <translation>请在程序副本中用它返回的数值代替。</translation>
    </message>
</context>
<context>
    <name>ErrorWord</name>
    <message>
        <source>bytes</source>
        <translation>字节</translation>
    </message>
    <message>
        <source>elements</source>
        <translation>元素</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>条目</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>facets</source>
        <translation>面片</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>poles</source>
        <translation>控制点</translation>
    </message>
    <message>
        <source>strips</source>
        <translation>三角带</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>a statement of the format</source>
        <translation>该格式的语句</translation>
    </message>
    <message>
        <source>a vertex number</source>
        <translation>顶点编号</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>行尾</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>面数</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>顶点数</translation>
    </message>
    <message>
        <source>the 3D model</source>
        <translation>三维模型</translation>
    </message>
    <message>
        <source>the joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>the link</source>
        <translation>连杆</translation>
    </message>
    <message>
        <source>the mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>the object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>the property</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>XML that declares entities</source>
        <translation>声明实体的 XML</translation>
    </message>
    <message>
        <source>a skinned mesh</source>
        <translation>蒙皮网格</translation>
    </message>
    <message>
        <source>a xacro file that is not expanded to URDF</source>
        <translation>未展开为 URDF 的 xacro 文件</translation>
    </message>
    <message>
        <source>the 3MF extension &apos;%1&apos;</source>
        <translation>3MF 扩展“%1”</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which leads too far away,</source>
        <translation>网格名“%1”（路径过远）</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which leaves its package,</source>
        <translation>网格名“%1”（超出所属软件包）</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which names no package,</source>
        <translation>网格名“%1”（未指明软件包）</translation>
    </message>
    <message>
        <source>the shape &apos;%1&apos;</source>
        <translation>形状“%1”</translation>
    </message>
    <message>
        <source>a coordinate of the mesh</source>
        <translation>网格坐标</translation>
    </message>
    <message>
        <source>an origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>chord tolerance</source>
        <translation>弦高公差</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>its triangles differ</source>
        <translation>三角形不一致</translation>
    </message>
    <message>
        <source>its volume differs</source>
        <translation>体积不一致</translation>
    </message>
    <message>
        <source>Its directory is wrong</source>
        <translation>目录有误</translation>
    </message>
    <message>
        <source>Not a regular file</source>
        <translation>不是普通文件</translation>
    </message>
    <message>
        <source>it is not a STEP file</source>
        <translation>不是 STEP 文件</translation>
    </message>
    <message>
        <source>the faces do not close</source>
        <translation>各面未封闭</translation>
    </message>
    <message>
        <source>the faces do not join</source>
        <translation>各面未相接</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>无法写入文件</translation>
    </message>
    <message>
        <source>the solid cannot be translated</source>
        <translation>实体无法转换</translation>
    </message>
    <message>
        <source>%1 of its polygons cannot be read</source>
        <translation>其中 %1 个多边形无法读取</translation>
    </message>
    <message>
        <source>a choice was expected</source>
        <translation>应为选项</translation>
    </message>
    <message>
        <source>a comment is too long</source>
        <translation>注释过长</translation>
    </message>
    <message>
        <source>a number was expected</source>
        <translation>应为数字</translation>
    </message>
    <message>
        <source>a pole is across the axis, too far away or not finite</source>
        <translation>某控制点越过轴线、过远或非有限值</translation>
    </message>
    <message>
        <source>a tag is too long</source>
        <translation>标签过长</translation>
    </message>
    <message>
        <source>a text is too long</source>
        <translation>文本过长</translation>
    </message>
    <message>
        <source>a text of at most 1000 bytes in UTF-8 was expected</source>
        <translation>应为不超过 1000 字节的 UTF-8 文本</translation>
    </message>
    <message>
        <source>a weight is missing, not positive or too large</source>
        <translation>某权重缺失、非正或过大</translation>
    </message>
    <message>
        <source>elements are nested too deeply</source>
        <translation>元素嵌套过深</translation>
    </message>
    <message>
        <source>it contains itself</source>
        <translation>它包含自身</translation>
    </message>
    <message>
        <source>it has a document type</source>
        <translation>含有文档类型声明</translation>
    </message>
    <message>
        <source>it has no links</source>
        <translation>没有连杆</translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation>缺少名称</translation>
    </message>
    <message>
        <source>it has no shape</source>
        <translation>缺少形状</translation>
    </message>
    <message>
        <source>it has no type</source>
        <translation>缺少类型</translation>
    </message>
    <message>
        <source>it has no %1</source>
        <translation>缺少“%1”</translation>
    </message>
    <message>
        <source>it has too few poles</source>
        <translation>控制点过少</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>嵌套过深</translation>
    </message>
    <message>
        <source>it is not JSON</source>
        <translation>不是 JSON</translation>
    </message>
    <message>
        <source>it is not an object</source>
        <translation>不是对象</translation>
    </message>
    <message>
        <source>it is not the root</source>
        <translation>不是根元素</translation>
    </message>
    <message>
        <source>it is not twelve numbers</source>
        <translation>不是十二个数</translation>
    </message>
    <message>
        <source>it lies on the axis</source>
        <translation>位于轴线上</translation>
    </message>
    <message>
        <source>it names no file</source>
        <translation>未指明文件</translation>
    </message>
    <message>
        <source>it names no joint</source>
        <translation>未指明关节</translation>
    </message>
    <message>
        <source>it names no %1</source>
        <translation>未指明“%1”</translation>
    </message>
    <message>
        <source>its axis has no direction</source>
        <translation>轴没有方向</translation>
    </message>
    <message>
        <source>its degree must be 1, 2 or 3</source>
        <translation>次数须为 1、2 或 3</translation>
    </message>
    <message>
        <source>its knots do not fit its poles</source>
        <translation>节点与控制点不匹配</translation>
    </message>
    <message>
        <source>its lower limit is above the upper one</source>
        <translation>下限高于上限</translation>
    </message>
    <message>
        <source>its object is of the type &apos;other&apos;</source>
        <translation>其对象类型为“other”</translation>
    </message>
    <message>
        <source>its type &apos;%1&apos; is not known</source>
        <translation>类型“%1”未知</translation>
    </message>
    <message>
        <source>its unit is &apos;%1&apos;</source>
        <translation>单位为“%1”</translation>
    </message>
    <message>
        <source>its vertices have no positions</source>
        <translation>其顶点没有位置</translation>
    </message>
    <message>
        <source>there are two of that name</source>
        <translation>有两个同名项</translation>
    </message>
    <message>
        <source>the firmware file</source>
        <translation>固件文件</translation>
    </message>
    <message>
        <source>a packet of the firmware</source>
        <translation>固件的数据包</translation>
    </message>
    <message>
        <source>an inventory with an Inverse3</source>
        <translation>包含 Inverse3 的设备清单</translation>
    </message>
    <message>
        <source>the bootloader&apos;s greeting</source>
        <translation>引导程序的问候</translation>
    </message>
    <message>
        <source>the echo of the first byte</source>
        <translation>第一个字节的回显</translation>
    </message>
    <message>
        <source>the firmware&apos;s echo</source>
        <translation>固件的回显</translation>
    </message>
    <message>
        <source>the handshake of a WebSocket</source>
        <translation>WebSocket 的握手</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>已拔出</translation>
    </message>
    <message>
        <source>it brings no driver</source>
        <translation>其中没有驱动程序</translation>
    </message>
    <message>
        <source>there is already a driver &apos;%1&apos;</source>
        <translation>已有驱动程序“%1”</translation>
    </message>
    <message>
        <source>ticks of the recording &apos;%1&apos;</source>
        <translation>录制“%1”的周期</translation>
    </message>
    <message>
        <source>the process that guards its motors has ended</source>
        <translation>看护其电机的进程已结束</translation>
    </message>
    <message>
        <source>attributes</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>ticks</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>the setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>it is not there</source>
        <translation>设备不存在</translation>
    </message>
    <message>
        <source>the picture has no pixels</source>
        <translation>图片没有像素</translation>
    </message>
    <message>
        <source>a rate or a time is not above zero</source>
        <translation>速率或时间不大于零</translation>
    </message>
    <message>
        <source>a short list of keys is expected</source>
        <translation>应为简短的按键列表</translation>
    </message>
    <message>
        <source>a whole number is expected</source>
        <translation>应为整数</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>应为对象</translation>
    </message>
    <message>
        <source>there is no such key</source>
        <translation>没有这样的按键</translation>
    </message>
    <message>
        <source>they do not fit the mesh</source>
        <translation>与网格不符</translation>
    </message>
    <message>
        <source>the number of samples is missing or impossible</source>
        <translation>采样点数缺失或不可能</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>走刀</translation>
    </message>
    <message>
        <source>samples of the profile</source>
        <translation>轮廓采样点</translation>
    </message>
    <message>
        <source>faces that can be triangulated</source>
        <translation>可三角化的面</translation>
    </message>
    <message>
        <source>parts that can be read</source>
        <translation>可读取的零件</translation>
    </message>
    <message>
        <source>it crashed on this file</source>
        <translation>它处理此文件时崩溃</translation>
    </message>
    <message>
        <source>it takes more than %1 triangles</source>
        <translation>需要超过 %1 个三角形</translation>
    </message>
    <message>
        <source>it took longer than %1 s</source>
        <translation>用时超过 %1 秒</translation>
    </message>
    <message>
        <source>its answer is too large</source>
        <translation>其结果过大</translation>
    </message>
    <message>
        <source>its process cannot be started</source>
        <translation>无法启动其进程</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>dimensions</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>a link to a file name that is not UTF-8</source>
        <translation>指向非 UTF-8 文件名的链接</translation>
    </message>
    <message>
        <source>setting %1</source>
        <translation>设置 %1</translation>
    </message>
    <message>
        <source>the shape %1</source>
        <translation>形状 %1</translation>
    </message>
    <message>
        <source>a colour such as #b8bcc7 was expected</source>
        <translation>应为颜色，例如 #b8bcc7</translation>
    </message>
    <message>
        <source>a text was expected</source>
        <translation>应为文本</translation>
    </message>
    <message>
        <source>its pose cannot be used</source>
        <translation>位姿无法使用</translation>
    </message>
    <message>
        <source>yes or no was expected</source>
        <translation>应为是或否</translation>
    </message>
    <message>
        <source>the package</source>
        <translation>软件包</translation>
    </message>
    <message>
        <source>it is longer than its size</source>
        <translation>它超出其大小</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>它不是普通文件</translation>
    </message>
    <message>
        <source>the position of the body</source>
        <translation>物体的位置</translation>
    </message>
    <message>
        <source>its position</source>
        <translation>其位置</translation>
    </message>
    <message>
        <source>a geometry that is not a mesh</source>
        <translation>非网格的几何体</translation>
    </message>
    <message>
        <source>the floating joint &apos;%1&apos;, which is treated as fixed,</source>
        <translation>浮动关节“%1”（已固定）</translation>
    </message>
    <message>
        <source>the planar joint &apos;%1&apos;, which is treated as fixed,</source>
        <translation>平面关节“%1”（已固定）</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which is not a file on this computer,</source>
        <translation>网格名“%1”（不是本机文件）</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which is on another computer,</source>
        <translation>网格名“%1”（位于其他机器）</translation>
    </message>
    <message>
        <source>it is inconsistent</source>
        <translation>内容不一致</translation>
    </message>
    <message>
        <source>its answer is not valid</source>
        <translation>其响应无效</translation>
    </message>
    <message>
        <source>it belongs to a closed loop of joints</source>
        <translation>它属于闭环关节链</translation>
    </message>
    <message>
        <source>the version of the format is missing</source>
        <translation>缺少格式版本</translation>
    </message>
    <message>
        <source>it mimics itself</source>
        <translation>它模仿自身（mimic）</translation>
    </message>
    <message>
        <source>its mimic factor or offset is too large</source>
        <translation>其模仿系数或偏移（mimic）过大</translation>
    </message>
    <message>
        <source>it is not a length; metres are assumed</source>
        <translation>不是长度；按米处理</translation>
    </message>
    <message>
        <source>it is instanced too often, or within itself</source>
        <translation>它被引用次数过多，或引用了自身</translation>
    </message>
    <message>
        <source>its joints form a closed loop</source>
        <translation>其关节构成闭环</translation>
    </message>
    <message>
        <source>its loops cannot be identified any more</source>
        <translation>已无法识别其边界环</translation>
    </message>
    <message>
        <source>its number %1 is already in use</source>
        <translation>其编号 %1 已被使用</translation>
    </message>
    <message>
        <source>its key is not a number</source>
        <translation>其键不是数字</translation>
    </message>
    <message>
        <source>its matrix is not a rotation</source>
        <translation>其矩阵不是旋转</translation>
    </message>
    <message>
        <source>cutting them again would take too long</source>
        <translation>重新切削它们耗时过长</translation>
    </message>
    <message>
        <source>its size is not a length</source>
        <translation>尺寸不是长度</translation>
    </message>
    <message>
        <source>its transformation is not valid</source>
        <translation>无法理解其变换</translation>
    </message>
    <message>
        <source>its triangles are inconsistent</source>
        <translation>其三角形不一致</translation>
    </message>
    <message>
        <source>link %1 already has a parent joint</source>
        <translation>连杆 %1 已有父关节</translation>
    </message>
    <message>
        <source>no joint connects it to %1</source>
        <translation>没有关节将其与 %1 相连</translation>
    </message>
    <message>
        <source>one of its indices is not a number</source>
        <translation>某个索引不是数字</translation>
    </message>
    <message>
        <source>it contains no valid solid</source>
        <translation>不含有效实体</translation>
    </message>
    <message>
        <source>its surfaces have zero size</source>
        <translation>其曲面没有大小</translation>
    </message>
    <message>
        <source>none of its surfaces can be triangulated</source>
        <translation>其曲面均无法三角化</translation>
    </message>
    <message>
        <source>the file contains no shape</source>
        <translation>文件不含形状</translation>
    </message>
    <message>
        <source>the file contains no surface</source>
        <translation>文件中没有曲面</translation>
    </message>
    <message>
        <source>the system ended it; it may have run out of memory</source>
        <translation>系统将其终止；可能内存不足</translation>
    </message>
    <message>
        <source>it has no limits, so it moves without limits</source>
        <translation>没有限位，因此不受限运动</translation>
    </message>
    <message>
        <source>its geometry has no type</source>
        <translation>其几何体没有类型</translation>
    </message>
    <message>
        <source>its scale is degenerate</source>
        <translation>其缩放为零，形状退化</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>轮廓段</translation>
    </message>
    <message>
        <source>the number of segments is missing or impossible</source>
        <translation>轮廓段数缺失或不可能</translation>
    </message>
    <message>
        <source>its radius is not above zero</source>
        <translation>半径不大于零</translation>
    </message>
    <message>
        <source>it has no extent</source>
        <translation>没有大小</translation>
    </message>
    <message>
        <source>it has no value</source>
        <translation>没有值</translation>
    </message>
    <message>
        <source>a command was expected</source>
        <translation>应为命令</translation>
    </message>
    <message>
        <source>it is not one that SVG has</source>
        <translation>不是 SVG 所具有的</translation>
    </message>
    <message>
        <source>a coordinate is too large</source>
        <translation>坐标过大</translation>
    </message>
    <message>
        <source>its answer is not understood</source>
        <translation>无法理解其响应</translation>
    </message>
    <message>
        <source>its outline differs</source>
        <translation>其轮廓线不一致</translation>
    </message>
    <message>
        <source>there are no fonts</source>
        <translation>没有字体</translation>
    </message>
    <message>
        <source>the page cannot be painted</source>
        <translation>无法绘制页面</translation>
    </message>
    <message>
        <source>a list was expected</source>
        <translation>应为列表</translation>
    </message>
    <message>
        <source>a nose radius is impossible</source>
        <translation>刀尖圆弧半径不可能</translation>
    </message>
    <message>
        <source>a number was expected, or nothing</source>
        <translation>应为数字或为空</translation>
    </message>
    <message>
        <source>a range ends before it begins</source>
        <translation>范围的终点在起点之前</translation>
    </message>
    <message>
        <source>a section has no corners, too many, or impossible ones</source>
        <translation>截面没有角点、角点过多或有不可能的角点</translation>
    </message>
    <message>
        <source>a switch was expected</source>
        <translation>应为开关值</translation>
    </message>
    <message>
        <source>a text in UTF-8 was expected</source>
        <translation>应为 UTF-8 文本</translation>
    </message>
    <message>
        <source>a tool is impossible</source>
        <translation>刀具不可能</translation>
    </message>
    <message>
        <source>an object was expected</source>
        <translation>应为对象</translation>
    </message>
    <message>
        <source>criteria</source>
        <translation>评分项</translation>
    </message>
    <message>
        <source>feed and spindle speed must be above 0</source>
        <translation>进给和主轴转速必须大于 0</translation>
    </message>
    <message>
        <source>it has too few points</source>
        <translation>点数过少</translation>
    </message>
    <message>
        <source>it is impossible</source>
        <translation>不可能</translation>
    </message>
    <message>
        <source>it is not 1</source>
        <translation>不是 1</translation>
    </message>
    <message>
        <source>it is not a list of the numbers that belong there</source>
        <translation>不是由应有数字组成的列表</translation>
    </message>
    <message>
        <source>it is not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>it is too long</source>
        <translation>过长</translation>
    </message>
    <message>
        <source>its kind is unknown</source>
        <translation>其类型未知</translation>
    </message>
    <message>
        <source>its time is impossible</source>
        <translation>其时间不可能</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>行</translation>
    </message>
    <message>
        <source>nothing is left of the part</source>
        <translation>零件已无剩余</translation>
    </message>
    <message>
        <source>numbers with “;” between them were expected</source>
        <translation>应为以“;”分隔的数字</translation>
    </message>
    <message>
        <source>one of its numbers is impossible</source>
        <translation>其中一个数字不可能</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>points of two numbers each were expected</source>
        <translation>应为各含两个数字的点</translation>
    </message>
    <message>
        <source>points were expected</source>
        <translation>应为点</translation>
    </message>
    <message>
        <source>property</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>the bore is longer than the part</source>
        <translation>孔比零件长</translation>
    </message>
    <message>
        <source>the bore is wider than the part</source>
        <translation>孔比零件宽</translation>
    </message>
    <message>
        <source>there are too many</source>
        <translation>数量过多</translation>
    </message>
    <message>
        <source>there are two with this id</source>
        <translation>有两个使用此 id</translation>
    </message>
    <message>
        <source>there is no such choice</source>
        <translation>没有这样的选项</translation>
    </message>
    <message>
        <source>too many sections, or no list</source>
        <translation>截面过多，或不是列表</translation>
    </message>
    <message>
        <source>it is of another kind</source>
        <translation>它属于另一种类型</translation>
    </message>
    <message>
        <source>it gives points without a limit</source>
        <translation>它给分却没有界限</translation>
    </message>
    <message>
        <source>its tolerance needs the nominal size</source>
        <translation>其公差需要公称尺寸</translation>
    </message>
    <message>
        <source>its tolerance is not a roughness grade, N1 to N12</source>
        <translation>其公差不是粗糙度等级 N1 至 N12</translation>
    </message>
    <message>
        <source>its figure takes limits, not a tolerance class</source>
        <translation>其指标用界限，不用公差带代号</translation>
    </message>
    <message>
        <source>its tolerance class is not known for this size; give limits instead</source>
        <translation>该尺寸没有此公差带；请改用界限</translation>
    </message>
    <message>
        <source>a thread needs a pitch</source>
        <translation>螺纹需要螺距</translation>
    </message>
    <message>
        <source>a thread is impossible</source>
        <translation>有一个螺纹无法实现</translation>
    </message>
    <message>
        <source>its upper end is not above the lower one</source>
        <translation>其上端不高于下端</translation>
    </message>
    <message>
        <source>it is beside the part</source>
        <translation>它在零件之外</translation>
    </message>
    <message>
        <source>it has more than 500 grooves</source>
        <translation>它的沟槽超过 500 条</translation>
    </message>
    <message>
        <source>there is no bore all along it</source>
        <translation>并非全长都有孔</translation>
    </message>
    <message>
        <source>there is no surface</source>
        <translation>没有表面</translation>
    </message>
    <message>
        <source>it is deeper than the part is thick</source>
        <translation>它比零件的壁还深</translation>
    </message>
    <message>
        <source>it touches nothing</source>
        <translation>它什么都没有接触</translation>
    </message>
    <message>
        <source>the bore is not open at an end of the part</source>
        <translation>内孔在零件两端均未开口</translation>
    </message>
    <message>
        <source>segments of five numbers each were expected</source>
        <translation>应为每段五个数字的线段</translation>
    </message>
    <message>
        <source>the part is in several pieces</source>
        <translation>零件分成了几块</translation>
    </message>
    <message>
        <source>a tool is impossible or not known</source>
        <translation>某个刀具不可能存在或未知</translation>
    </message>
    <message>
        <source>a point is too far away</source>
        <translation>一个点太远</translation>
    </message>
    <message>
        <source>cutting them would take too long</source>
        <translation>切削它们耗时过长</translation>
    </message>
    <message>
        <source>names were expected</source>
        <translation>应为名称</translation>
    </message>
    <message>
        <source>start and goal need a number for each joint</source>
        <translation>起点和终点的每个关节都需要一个数值</translation>
    </message>
    <message>
        <source>it has too many joints</source>
        <translation>关节过多</translation>
    </message>
    <message>
        <source>a planned joint moves others with it</source>
        <translation>一个被规划的关节会带动其他关节</translation>
    </message>
    <message>
        <source>a planned joint is not in it</source>
        <translation>其中没有某个被规划的关节</translation>
    </message>
    <message>
        <source>the planned joints are not in order</source>
        <translation>被规划的关节顺序不对</translation>
    </message>
    <message>
        <source>a joint is geared</source>
        <translation>一个关节带有传动比</translation>
    </message>
    <message>
        <source>a degree of freedom moves several joints</source>
        <translation>一个自由度带动多个关节</translation>
    </message>
    <message>
        <source>its name is impossible</source>
        <translation>其名称无效</translation>
    </message>
    <message>
        <source>its type is not known</source>
        <translation>其类型未知</translation>
    </message>
    <message>
        <source>a number within the limits was expected</source>
        <translation>应为范围内的数值</translation>
    </message>
    <message>
        <source>1 or -1 was expected</source>
        <translation>应为 1 或 -1</translation>
    </message>
    <message>
        <source>mm or m was expected</source>
        <translation>应为 mm 或 m</translation>
    </message>
    <message>
        <source>a length was expected</source>
        <translation>应为长度</translation>
    </message>
    <message>
        <source>its name is not unique</source>
        <translation>其名称不唯一</translation>
    </message>
    <message>
        <source>a list of names was expected</source>
        <translation>应为名称列表</translation>
    </message>
    <message>
        <source>a number for each joint was expected</source>
        <translation>每个关节应有一个数值</translation>
    </message>
    <message>
        <source>its joints are missing</source>
        <translation>缺少关节</translation>
    </message>
    <message>
        <source>joint or linear was expected</source>
        <translation>应为 joint 或 linear</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>places</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>motions</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>the %1 program</source>
        <translation>%1 程序</translation>
    </message>
    <message>
        <source>a name and := were expected</source>
        <translation>应为名称和 :=</translation>
    </message>
    <message>
        <source>numbers in brackets were expected</source>
        <translation>应为括号中的数值</translation>
    </message>
    <message>
        <source>there are too many motions</source>
        <translation>运动太多</translation>
    </message>
    <message>
        <source>it is neither numbers nor a name given before</source>
        <translation>既不是数值，也不是先前定义的名称</translation>
    </message>
    <message>
        <source>functions as Offs are not read</source>
        <translation>不读取 Offs 之类的函数</translation>
    </message>
    <message>
        <source>it has too few numbers</source>
        <translation>数值太少</translation>
    </message>
    <message>
        <source>its quaternion has no direction</source>
        <translation>其四元数没有方向</translation>
    </message>
    <message>
        <source>six axes or X, Y, Z, A, B, C were expected</source>
        <translation>应为六个轴或 X、Y、Z、A、B、C</translation>
    </message>
    <message>
        <source>six numbers in brackets were expected</source>
        <translation>应为括号中的六个数值</translation>
    </message>
    <message>
        <source>P[number] was expected</source>
        <translation>应为 P[编号]</translation>
    </message>
    <message>
        <source>its place is not in /POS, or not all of it</source>
        <translation>其位置不在 /POS 中，或不完整</translation>
    </message>
    <message>
        <source>a number and a name were expected</source>
        <translation>应为编号和名称</translation>
    </message>
    <message>
        <source>a place in another frame than UF : 0</source>
        <translation>不在 UF : 0 坐标系中的位置</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>过渡</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>there are too many tools</source>
        <translation>刀具过多</translation>
    </message>
    <message>
        <source>a robot is not in the description</source>
        <translation>有机器人不在描述中</translation>
    </message>
    <message>
        <source>the robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>a cell with several robots as one robot</source>
        <translation>将含多个机器人的单元作为一个机器人</translation>
    </message>
    <message>
        <source>criterion %1</source>
        <translation>评分项 %1</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>步骤 %1</translation>
    </message>
    <message>
        <source>places of a path</source>
        <translation>路径的位置</translation>
    </message>
    <message>
        <source>paths</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>configurations</source>
        <translation>位形</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>允许接触的对</translation>
    </message>
    <message>
        <source>allowed pairs</source>
        <translation>允许接触的对</translation>
    </message>
    <message>
        <source>its data are not in the file, or the robot does not hold it</source>
        <translation>其数据不在文件中，或机器人未持有它</translation>
    </message>
    <message>
        <source>its data are not in the file, or it moves</source>
        <translation>其数据不在文件中，或它会移动</translation>
    </message>
    <message>
        <source>its tool or base is on the controller, not in the file</source>
        <translation>其工具或基坐标系在控制器上，不在文件中</translation>
    </message>
    <message>
        <source>it is of another tool than those before</source>
        <translation>它所用的工具与之前的不同</translation>
    </message>
    <message>
        <source>CalcRobT has another tool or frame than the motion</source>
        <translation>CalcRobT 的工具或坐标系与运动的不同</translation>
    </message>
    <message>
        <source>routines call each other endlessly</source>
        <translation>例行程序之间无限地相互调用</translation>
    </message>
    <message>
        <source>%1 of its chunks are lost, or end early</source>
        <translation>其中 %1 个数据块丢失或提前结束</translation>
    </message>
    <message>
        <source>it is no place</source>
        <translation>不是位置</translation>
    </message>
    <message>
        <source>a saved document as a robot</source>
        <translation>把已保存的文档当作机器人</translation>
    </message>
    <message>
        <source>its tolerance class has no letter; give one, as in h10, H10 or js10</source>
        <translation>其公差带代号没有字母；请给出字母，如 h10、H10 或 js10</translation>
    </message>
    <message>
        <source>files in the folder</source>
        <translation>文件夹中的文件</translation>
    </message>
    <message>
        <source>bytes of DICOM files</source>
        <translation>DICOM 文件的字节</translation>
    </message>
    <message>
        <source>a data file outside of the folder</source>
        <translation>文件夹之外的数据文件</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>过大</translation>
    </message>
    <message>
        <source>it has no grid of floats</source>
        <translation>没有浮点数网格</translation>
    </message>
    <message>
        <source>it bounds no material</source>
        <translation>未围成任何材料</translation>
    </message>
    <message>
        <source>bytes of samples</source>
        <translation>采样点的字节</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>采样点</translation>
    </message>
    <message>
        <source>it has no samples</source>
        <translation>没有采样点</translation>
    </message>
    <message>
        <source>samples along an axis</source>
        <translation>沿单个轴的采样点</translation>
    </message>
    <message>
        <source>it is not finite</source>
        <translation>不是有限值</translation>
    </message>
    <message>
        <source>the axes lie in one plane</source>
        <translation>各轴位于同一平面内</translation>
    </message>
    <message>
        <source>the compressed data end too early</source>
        <translation>压缩数据提前结束</translation>
    </message>
    <message>
        <source>the compressed data are damaged</source>
        <translation>压缩数据已损坏</translation>
    </message>
    <message>
        <source>there are not as many numbers as it takes</source>
        <translation>数字的个数不足</translation>
    </message>
    <message>
        <source>a MetaImage object other than an image</source>
        <translation>非图像的 MetaImage 对象</translation>
    </message>
    <message>
        <source>an image of other than two to four axes</source>
        <translation>轴数不是二至四的图像</translation>
    </message>
    <message>
        <source>an image in several data files</source>
        <translation>分为多个数据文件的图像</translation>
    </message>
    <message>
        <source>an image of colours or complex numbers</source>
        <translation>彩色或复数图像</translation>
    </message>
    <message>
        <source>an image in a pair of .hdr and .img</source>
        <translation>由一对 .hdr 和 .img 文件组成的图像</translation>
    </message>
    <message>
        <source>there is not one for each axis</source>
        <translation>并非每个轴各有一个</translation>
    </message>
    <message>
        <source>a sample of more than 1000 values</source>
        <translation>超过 1000 个值的采样点</translation>
    </message>
    <message>
        <source>an encoding other than raw, gzip or text</source>
        <translation>raw、gzip 或 text 以外的编码</translation>
    </message>
    <message>
        <source>it is not three numbers</source>
        <translation>不是三个数字</translation>
    </message>
    <message>
        <source>it is not three numbers of samples</source>
        <translation>不是三个采样点数目</translation>
    </message>
    <message>
        <source>it is not three vectors</source>
        <translation>不是三个向量</translation>
    </message>
    <message>
        <source>it is neither little nor big</source>
        <translation>既不是 little 也不是 big</translation>
    </message>
    <message>
        <source>its slices are too far apart</source>
        <translation>其切片间距过大</translation>
    </message>
    <message>
        <source>the file contains no image in grey</source>
        <translation>文件中没有灰度图像</translation>
    </message>
    <message>
        <source>its slices do not lie along one line</source>
        <translation>其切片不在一条直线上</translation>
    </message>
    <message>
        <source>it is no grid of samples</source>
        <translation>不是采样点网格</translation>
    </message>
    <message>
        <source>the pixels of a slice cannot be unpacked</source>
        <translation>无法解压切片的像素</translation>
    </message>
    <message>
        <source>the size in front of its tolerance is not the nominal size</source>
        <translation>公差前的尺寸不是公称尺寸</translation>
    </message>
    <message>
        <source>a drill is impossible or not known</source>
        <translation>某个钻头不可能存在或未知</translation>
    </message>
    <message>
        <source>a drill was expected, such as ball:6, burr:4 or twist:3</source>
        <translation>应为钻头，例如 ball:6、burr:4 或 twist:3</translation>
    </message>
    <message>
        <source>a hole has too many poses</source>
        <translation>某个孔的位姿过多</translation>
    </message>
    <message>
        <source>a list of holes was expected</source>
        <translation>应为孔的列表</translation>
    </message>
    <message>
        <source>a pose of the drill is impossible</source>
        <translation>钻头的某个位姿不可能</translation>
    </message>
    <message>
        <source>balls were expected: x; y; z; radius, with “|” between them</source>
        <translation>应为球：x; y; z; 半径，之间以“|”分隔</translation>
    </message>
    <message>
        <source>figures of drilling have limits, no tolerance</source>
        <translation>钻孔的指标有限值，没有公差</translation>
    </message>
    <message>
        <source>it is no drill</source>
        <translation>不是钻头</translation>
    </message>
    <message>
        <source>points were expected: time, depth, beside, across, in order of time</source>
        <translation>应为点：时间、深度、偏离、横向，按时间顺序排列</translation>
    </message>
    <message>
        <source>poses of the drill are lost</source>
        <translation>钻头的位姿丢失</translation>
    </message>
    <message>
        <source>three lengths were expected, with “;” between them</source>
        <translation>应为三个长度，之间以“;”分隔</translation>
    </message>
    <message>
        <source>three numbers were expected, with “;” between them</source>
        <translation>应为三个数字，之间以“;”分隔</translation>
    </message>
    <message>
        <source>its voxels are not cubes along the axes</source>
        <translation>其体素不是沿坐标轴的立方体</translation>
    </message>
    <message>
        <source>it is not a scale factor</source>
        <translation>不是缩放系数</translation>
    </message>
    <message>
        <source>it is not a distance of samples</source>
        <translation>不是采样点的间距</translation>
    </message>
    <message>
        <source>one is not a number of samples</source>
        <translation>其中一个不是采样点的数目</translation>
    </message>
    <message>
        <source>it is not a type of numbers</source>
        <translation>不是数字的类型</translation>
    </message>
    <message>
        <source>it is not a number of values</source>
        <translation>不是值的数目</translation>
    </message>
    <message>
        <source>it is more than the file contains</source>
        <translation>超出文件所含的内容</translation>
    </message>
    <message>
        <source>it is not a number of axes</source>
        <translation>不是轴的数目</translation>
    </message>
    <message>
        <source>it is not a position after the header</source>
        <translation>不是文件头之后的位置</translation>
    </message>
    <message>
        <source>one is not a vector in space</source>
        <translation>其中一个不是空间向量</translation>
    </message>
    <message>
        <source>it is not a number of lines</source>
        <translation>不是行的数目</translation>
    </message>
    <message>
        <source>it is not a number</source>
        <translation>不是数字</translation>
    </message>
    <message>
        <source>it is not a grid of samples</source>
        <translation>不是采样点网格</translation>
    </message>
    <message>
        <source>%1 of its samples are lost</source>
        <translation>其中 %1 个采样点丢失</translation>
    </message>
    <message>
        <source>its samples are lost</source>
        <translation>其采样点丢失</translation>
    </message>
    <message>
        <source>it is no range of values</source>
        <translation>不是值的范围</translation>
    </message>
    <message>
        <source>part of what was painted is lost</source>
        <translation>部分涂绘内容丢失</translation>
    </message>
    <message>
        <source>full and empty blocks have no surface between them</source>
        <translation>实块与空块之间没有表面</translation>
    </message>
    <message>
        <source>it is not a number of chunks</source>
        <translation>不是数据块的数目</translation>
    </message>
    <message>
        <source>it is not the size of a voxel</source>
        <translation>不是体素的尺寸</translation>
    </message>
    <message>
        <source>its code is not a number</source>
        <translation>其代码不是数字</translation>
    </message>
    <message>
        <source>one of them is not a box, cylinder or sphere</source>
        <translation>其中一个不是长方体、圆柱或球</translation>
    </message>
    <message>
        <source>the tip is not connected to the base</source>
        <translation>末端未与基座相连</translation>
    </message>
    <message>
        <source>the z of the points is not ascending</source>
        <translation>各点的 Z 值不是升序</translation>
    </message>
    <message>
        <source>it refers to a criterion that does not exist</source>
        <translation>引用了不存在的评分项</translation>
    </message>
    <message>
        <source>its lists differ in length, or are not ascending</source>
        <translation>其各列表长度不同或不是升序</translation>
    </message>
    <message>
        <source>it does not specify which routine is the first</source>
        <translation>未指明首先执行哪个例行程序</translation>
    </message>
    <message>
        <source>its class needs the thread in front of it, as in M20x2.5-6g</source>
        <translation>公差带前需要写出螺纹，如 M20x2.5-6g</translation>
    </message>
    <message>
        <source>its tolerance is not that of a thread, as M20x2.5-6g or M20-6H</source>
        <translation>公差不是螺纹公差，如 M20x2.5-6g 或 M20-6H</translation>
    </message>
    <message>
        <source>its sides are not known</source>
        <translation>不认识其方位</translation>
    </message>
    <message>
        <source>it is not a list of holes</source>
        <translation>不是孔的列表</translation>
    </message>
    <message>
        <source>it is not a volume</source>
        <translation>不是体素模型</translation>
    </message>
    <message>
        <source>its samples need more memory than there is</source>
        <translation>其采样点所需内存超过现有内存</translation>
    </message>
    <message>
        <source>bytes of the data file</source>
        <translation>数据文件的字节数</translation>
    </message>
    <message>
        <source>bytes of the unpacked image</source>
        <translation>解压后图像的字节数</translation>
    </message>
    <message>
        <source>bytes of a picture</source>
        <translation>图片的字节数</translation>
    </message>
    <message>
        <source>pixels of a picture</source>
        <translation>图片的像素数</translation>
    </message>
    <message>
        <source>the robot reaches its place in no way with these S and T</source>
        <translation>机器人无法以这样的 S 和 T 到达该位置</translation>
    </message>
    <message>
        <source>it is not YAML</source>
        <translation>不是 YAML</translation>
    </message>
    <message>
        <source>there are none, or more than %1</source>
        <translation>没有，或多于 %1 个</translation>
    </message>
    <message>
        <source>a joint of the goal is missing</source>
        <translation>缺少目标的一个关节</translation>
    </message>
    <message>
        <source>a position for each name was expected</source>
        <translation>每个名称应有一个位置</translation>
    </message>
    <message>
        <source>one goal with joint_constraints, and nothing else, was expected</source>
        <translation>应为仅含 joint_constraints 的一个目标</translation>
    </message>
    <message>
        <source>a square of true and false was expected</source>
        <translation>应为由 true 和 false 组成的方阵</translation>
    </message>
    <message>
        <source>they are not supported</source>
        <translation>它们不受支持</translation>
    </message>
    <message>
        <source>it is not supported</source>
        <translation>不受支持</translation>
    </message>
    <message>
        <source>the frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>the volume was changed without them</source>
        <translation>体积在没有它们的情况下被更改</translation>
    </message>
    <message>
        <source>the robot reaches its place in no way with this configuration</source>
        <translation>机器人以此构型无法到达该位置</translation>
    </message>
    <message>
        <source>it is not a list of tries</source>
        <translation>它不是尝试的列表</translation>
    </message>
    <message>
        <source>a try is impossible</source>
        <translation>某次尝试不可能成立</translation>
    </message>
    <message>
        <source>the bottom of its bore is neither flat nor the cone of a drill of 118°</source>
        <translation>其孔底既不是平面，也不是 118° 钻头的锥面</translation>
    </message>
    <message>
        <source>Draw one of these, or write a program of your own.</source>
        <translation>请绘制其中之一，或编写您自己的程序。</translation>
    </message>
    <message>
        <source>the picture could not be rendered</source>
        <translation>图片无法绘制</translation>
    </message>
    <message>
        <source>its shape is not missing</source>
        <translation>其形状并未缺失</translation>
    </message>
    <message>
        <source>a list of lines was expected</source>
        <translation>此处应为行的列表</translation>
    </message>
    <message>
        <source>the tool turns by more than half a turn along the arc: divide it into two</source>
        <translation>工具沿圆弧转动超过半圈：请分成两段</translation>
    </message>
    <message>
        <source>functions but Offs and RelTool are not read</source>
        <translation>除 Offs 和 RelTool 外的函数不被读取</translation>
    </message>
    <message>
        <source>a target and three numbers were expected</source>
        <translation>此处应为一个目标和三个数</translation>
    </message>
    <message>
        <source>its displacement is neither a number nor a CONST num of the module</source>
        <translation>其位移既不是数，也不是模块的 CONST num</translation>
    </message>
    <message>
        <source>a place on the arc was expected</source>
        <translation>此处应为圆弧上的一点</translation>
    </message>
    <message>
        <source>the start of the arc is not known</source>
        <translation>圆弧的起点未知</translation>
    </message>
    <message>
        <source>the three places of the arc are in a line</source>
        <translation>圆弧的三点共线</translation>
    </message>
    <message>
        <source>the arc is longer than half a circle: divide it into two</source>
        <translation>圆弧超过半圆：请分成两段</translation>
    </message>
    <message>
        <source>it is neither numbers nor a variable that was given numbers before</source>
        <translation>既不是数，也不是先前被赋予数的变量</translation>
    </message>
    <message>
        <source>line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>an external axis moves, and only axes of the robot can</source>
        <translation>有外部轴在运动，而只有机器人的轴可以运动</translation>
    </message>
    <message>
        <source>there are too many without a motion</source>
        <translation>没有运动的行太多</translation>
    </message>
    <message>
        <source>too many functions are within each other</source>
        <translation>函数嵌套过多</translation>
    </message>
    <message>
        <source>two routines have the name that it calls</source>
        <translation>有两个例程具有所调用的名称</translation>
    </message>
    <message>
        <source>it is in /POS twice</source>
        <translation>在 /POS 中出现两次</translation>
    </message>
    <message>
        <source>its slices have neither positions nor a stated distance</source>
        <translation>其切片既没有位置，也没有给出间距</translation>
    </message>
    <message>
        <source>it has too many slices</source>
        <translation>其切片过多</translation>
    </message>
    <message>
        <source>its frame or tool is not the selected one</source>
        <translation>其坐标系或工具不是所选的</translation>
    </message>
    <message>
        <source>it holds contours of regions (an RT structure set), not an image</source>
        <translation>文件包含区域轮廓（RT 结构集），而不是图像</translation>
    </message>
    <message>
        <source>it holds a colour image, not one in grey</source>
        <translation>文件包含彩色图像，而不是灰度图像</translation>
    </message>
    <message>
        <source>its segments have slices with uneven distances</source>
        <translation>其分割的切片间距不均匀</translation>
    </message>
    <message>
        <source>its segments have no positions</source>
        <translation>其分割没有位置信息</translation>
    </message>
    <message>
        <source>it holds a plan, a report or another object without an image</source>
        <translation>文件包含计划、报告或其他没有图像的对象</translation>
    </message>
</context>
<context>
    <name>Exercise</name>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>A ball of 36 mm on a neck of 12 mm.</source>
        <translation>直径 36 mm 的球，颈部直径 12 mm。</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>粗车</translation>
    </message>
    <message>
        <source>Take the material off in passes of 1.5 mm and leave 0.4 mm on the radius.</source>
        <translation>以每刀 1.5 mm 的吃刀量去除余料，半径上留 0.4 mm 余量。</translation>
    </message>
    <message>
        <source>Begin each pass in the air at the end of the bar.</source>
        <translation>每次走刀都从棒料端面外的空处开始。</translation>
    </message>
    <message>
        <source>The read-out shows the diameter: 0.4 mm on the radius are 0.8 mm on the diameter.</source>
        <translation>读数显示的是直径：半径上的 0.4 mm 即直径上的 0.8 mm。</translation>
    </message>
    <message>
        <source>Move both slides at once along the circle.</source>
        <translation>同时移动两个拖板，沿圆弧走刀。</translation>
    </message>
    <message>
        <source>Begin at the pole, where the ball ends, and go towards the chuck.</source>
        <translation>从球的末端即顶点处开始，向卡盘方向走刀。</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>精车</translation>
    </message>
    <message>
        <source>Follow the outline in one pass at 0.1 mm per revolution.</source>
        <translation>以每转 0.1 mm 的进给沿轮廓一刀车成。</translation>
    </message>
    <message>
        <source>The slower the feed, the finer the surface.</source>
        <translation>进给越慢，表面越光洁。</translation>
    </message>
    <message>
        <source>Form within 0.1 mm</source>
        <translation>形状偏差在 0.1 mm 以内</translation>
    </message>
    <message>
        <source>Radius 18 ±0.1</source>
        <translation>半径 18 ±0.1</translation>
    </message>
    <message>
        <source>Finish N8</source>
        <translation>粗糙度 N8</translation>
    </message>
    <message>
        <source>No collision, no feed too high</source>
        <translation>无碰撞，进给不过大</translation>
    </message>
    <message>
        <source>Cutting force within that of the lathe</source>
        <translation>切削力不超过车床允许值</translation>
    </message>
    <message>
        <source>Power within that of the motor</source>
        <translation>功率不超过电机功率</translation>
    </message>
    <message>
        <source>In the time</source>
        <translation>在规定时间内</translation>
    </message>
    <message>
        <source>Without many hints</source>
        <translation>少看提示</translation>
    </message>
    <message>
        <source>Bored bush</source>
        <translation>镗孔衬套</translation>
    </message>
    <message>
        <source>A bush with a bore to H10.</source>
        <translation>内孔公差为 H10 的衬套。</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>外圆</translation>
    </message>
    <message>
        <source>Turn ⌀44 over 30 mm.</source>
        <translation>将 30 mm 长度车至 ⌀44。</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>镗孔</translation>
    </message>
    <message>
        <source>Bore in passes of 1.5 mm to 0.4 mm below the size.</source>
        <translation>以每刀 1.5 mm 的吃刀量镗孔，镗至比尺寸小 0.4 mm。</translation>
    </message>
    <message>
        <source>The bore has no chips to see: listen.</source>
        <translation>孔内看不到切屑：请听声音。</translation>
    </message>
    <message>
        <source>Finish the bore</source>
        <translation>精镗内孔</translation>
    </message>
    <message>
        <source>One pass at 0.1 mm per revolution.</source>
        <translation>以每转 0.1 mm 的进给一刀完成。</translation>
    </message>
    <message>
        <source>⌀25 H10 bore</source>
        <translation>⌀25 H10 内孔</translation>
    </message>
    <message>
        <source>Depth 28 ±0.2</source>
        <translation>深度 28 ±0.2</translation>
    </message>
    <message>
        <source>Dumb-bell weight</source>
        <translation>哑铃</translation>
    </message>
    <message>
        <source>Two equal heads with a handle between them.</source>
        <translation>两个相同的铃头，中间是握柄。</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>握柄</translation>
    </message>
    <message>
        <source>Turn the handle between the two heads.</source>
        <translation>在两个铃头之间车出握柄。</translation>
    </message>
    <message>
        <source>The faces of the heads are 34 mm apart.</source>
        <translation>两铃头的端面相距 34 mm。</translation>
    </message>
    <message>
        <source>Handle 34 ±0.2</source>
        <translation>握柄 34 ±0.2</translation>
    </message>
    <message>
        <source>Your first shoulder</source>
        <translation>您的第一个台阶</translation>
    </message>
    <message>
        <source>Turn the end of a bar of 40 mm down to 30 mm, over a length of 30 mm. It takes a few minutes.</source>
        <translation>将直径 40 mm 的棒料一端车至 30 mm，长度 30 mm。只需几分钟。</translation>
    </message>
    <message>
        <source>Choose the tool</source>
        <translation>选择刀具</translation>
    </message>
    <message>
        <source>Press V, or choose “Turn” above. A round tool appears at the pointer; the grey bar turns all the time, so only the distance from its axis matters.</source>
        <translation>按 V 键，或在上方选择“车削”。指针处会出现圆头刀具；灰色棒料一直在旋转，因此只有刀具到轴线的距离才重要。</translation>
    </message>
    <message>
        <source>First pass</source>
        <translation>第一刀</translation>
    </message>
    <message>
        <source>Go with the pointer to the right end of the bar, just inside its edge. Hold the left button, and drag slowly along the bar over 30 mm. The label shows the diameter ⌀ that is left, and the feed f: more than 1 mm per revolution, 13 mm a second, is too fast; below 0.25 mm the surface becomes fine.</source>
        <translation>将指针移到棒料右端，刚好在其边缘以内。按住左键，沿棒料缓慢拖动 30 mm。标签显示车后剩余的直径 ⌀ 和进给 f：每转超过 1 mm（即每秒 13 mm）过快；低于 0.25 mm 时表面变得光洁。</translation>
    </message>
    <message>
        <source>Nothing is cut while the tool is outside of the bar. Begin beyond its end and come in slowly.</source>
        <translation>刀具在棒料之外时不切削。请从棒料端面之外开始，慢慢切入。</translation>
    </message>
    <message>
        <source>Ctrl+Z takes a pass back.</source>
        <translation>Ctrl+Z 可撤销一次走刀。</translation>
    </message>
    <message>
        <source>Go deeper</source>
        <translation>加大切深</translation>
    </message>
    <message>
        <source>Repeat it a little deeper each time, until the label shows ⌀30.</source>
        <translation>重复走刀，每次再深一点，直到标签显示 ⌀30。</translation>
    </message>
    <message>
        <source>Two or three passes are enough.</source>
        <translation>走两三刀就够了。</translation>
    </message>
    <message>
        <source>The shoulder</source>
        <translation>台阶</translation>
    </message>
    <message>
        <source>Let the pass end 30 mm from the end, so that a face stands there.</source>
        <translation>使走刀在距端面 30 mm 处结束，在该处形成台阶端面。</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Press “Measure” below. Lines with ✓ are right; with ✗, take another pass.</source>
        <translation>按下方的“测量”。标有 ✓ 的行合格；标有 ✗ 时请再走一刀。</translation>
    </message>
    <message>
        <source>Length 30 ±1</source>
        <translation>长度 30 ±1</translation>
    </message>
    <message>
        <source>Gourd</source>
        <translation>葫芦</translation>
    </message>
    <message>
        <source>Two bulbs with a waist, by hand and eye.</source>
        <translation>两个鼓肚，中间一道细腰，凭手感和目测车成。</translation>
    </message>
    <message>
        <source>Waist</source>
        <translation>细腰</translation>
    </message>
    <message>
        <source>Find the narrowest place, 36 mm from the end.</source>
        <translation>找到最细处，距端面 36 mm。</translation>
    </message>
    <message>
        <source>Plunge a little, measure, and plunge again.</source>
        <translation>径向切入少许，测量，再切入。</translation>
    </message>
    <message>
        <source>Form within 0.15 mm</source>
        <translation>形状偏差在 0.15 mm 以内</translation>
    </message>
    <message>
        <source>Shaft with shoulders</source>
        <translation>台阶轴</translation>
    </message>
    <message>
        <source>Three diameters to h10 with exact lengths.</source>
        <translation>三个公差为 h10 的直径，长度精确。</translation>
    </message>
    <message>
        <source>First shoulder</source>
        <translation>第一个台阶</translation>
    </message>
    <message>
        <source>Turn ⌀20 over 30 mm.</source>
        <translation>将 30 mm 长度车至 ⌀20。</translation>
    </message>
    <message>
        <source>Touch off at the end first.</source>
        <translation>请先在端面对刀。</translation>
    </message>
    <message>
        <source>Second shoulder</source>
        <translation>第二个台阶</translation>
    </message>
    <message>
        <source>Turn ⌀28 over the next 30 mm.</source>
        <translation>将接下来的 30 mm 长度车至 ⌀28。</translation>
    </message>
    <message>
        <source>Third shoulder</source>
        <translation>第三个台阶</translation>
    </message>
    <message>
        <source>Turn ⌀36 over 25 mm.</source>
        <translation>将 25 mm 长度车至 ⌀36。</translation>
    </message>
    <message>
        <source>Length 30 ±0.1</source>
        <translation>长度 30 ±0.1</translation>
    </message>
    <message>
        <source>Thread M20</source>
        <translation>螺纹 M20</translation>
    </message>
    <message>
        <source>A thread M20 × 2.5 - 6g with relief and chamfer.</source>
        <translation>带退刀槽和倒角的 M20 × 2.5 - 6g 螺纹。</translation>
    </message>
    <message>
        <source>Major diameter</source>
        <translation>大径</translation>
    </message>
    <message>
        <source>Turn to 19.8 mm, as a thread M20 with a pitch of 2.5 mm begins.</source>
        <translation>车至 19.8 mm，即车削螺距 2.5 mm 的 M20 螺纹之前的直径。</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>退刀槽</translation>
    </message>
    <message>
        <source>Groove to 16.4 mm beside the collar, where the thread runs out.</source>
        <translation>在轴肩旁切槽至 16.4 mm，螺纹在此处收尾。</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>螺纹</translation>
    </message>
    <message>
        <source>Cut the thread with the tool of 60°: passes of falling depth, down to a pitch diameter of 18.25 mm.</source>
        <translation>用 60° 螺纹车刀车螺纹：吃刀量逐刀递减，直至中径 18.25 mm。</translation>
    </message>
    <message>
        <source>On the lathe, set the pitch and close the half-nut in front of the end of the bar; open it in the relief.</source>
        <translation>在车床上，设定螺距，在棒料端面之外合上开合螺母；在退刀槽中打开开合螺母。</translation>
    </message>
    <message>
        <source>A lead that is a part of the lead screw&apos;s pitch always finds its groove again.</source>
        <translation>丝杠螺距是所车导程的整数倍时，车刀总能重新落入原来的牙槽，不会乱牙。</translation>
    </message>
    <message>
        <source>⌀20 6g major diameter</source>
        <translation>大径 ⌀20 6g</translation>
    </message>
    <message>
        <source>Pitch 2.5 ±0.02</source>
        <translation>螺距 2.5 ±0.02</translation>
    </message>
    <message>
        <source>Pitch diameter 18.376 6g</source>
        <translation>中径 18.376 6g</translation>
    </message>
    <message>
        <source>Minor diameter 6g</source>
        <translation>小径 6g</translation>
    </message>
    <message>
        <source>To the collar 40 ±0.2</source>
        <translation>到轴肩 40 ±0.2</translation>
    </message>
    <message>
        <source>Chamfer 45°</source>
        <translation>倒角 45°</translation>
    </message>
    <message>
        <source>Wine glass</source>
        <translation>酒杯</translation>
    </message>
    <message>
        <source>A glass with a hollow bowl on a thin stem.</source>
        <translation>细杯柄上带空心杯身的酒杯。</translation>
    </message>
    <message>
        <source>Hollow the bowl</source>
        <translation>挖空杯身</translation>
    </message>
    <message>
        <source>Bore from the end in passes of 1.5 mm, while the stem is still thick.</source>
        <translation>趁杯柄还粗，从端面开始以每刀 1.5 mm 的吃刀量镗孔。</translation>
    </message>
    <message>
        <source>What is hollowed last breaks the stem.</source>
        <translation>若最后才挖空，杯柄会折断。</translation>
    </message>
    <message>
        <source>Stem</source>
        <translation>杯柄</translation>
    </message>
    <message>
        <source>Turn the stem to 8 mm.</source>
        <translation>将杯柄车至 8 mm。</translation>
    </message>
    <message>
        <source>Small cuts: the stem bends.</source>
        <translation>吃刀量要小：杯柄会弯曲。</translation>
    </message>
    <message>
        <source>Depth of the bowl 39 ±0.5</source>
        <translation>杯身深度 39 ±0.5</translation>
    </message>
    <message>
        <source>turning tool</source>
        <translation>车刀</translation>
    </message>
    <message>
        <source>Burr hole in the skull</source>
        <translation>颅骨钻孔</translation>
    </message>
    <message>
        <source>Drill through the skull along the planned path, and stop before the brain.</source>
        <translation>沿规划路径钻穿颅骨，并在到达大脑之前停止。</translation>
    </message>
    <message>
        <source>Choose the drill</source>
        <translation>选择钻头</translation>
    </message>
    <message>
        <source>Press Shift+D, or choose “Drill” above. Drill, speed and material are those of the exercise. The green rod shows the planned path.</source>
        <translation>按 Shift+D，或选择上方的“钻孔”。钻头、转速和材料由练习规定。绿色细杆表示规划路径。</translation>
    </message>
    <message>
        <source>Find the place</source>
        <translation>找到位置</translation>
    </message>
    <message>
        <source>Go with the pointer to where the green rod meets the skull. The circle shows the drill.</source>
        <translation>将指针移到绿色细杆与颅骨相交处。圆圈表示钻头。</translation>
    </message>
    <message>
        <source>Turn the view until you look along the rod.</source>
        <translation>转动视图，直到视线沿着细杆。</translation>
    </message>
    <message>
        <source>With Shift held, the drill goes straight along the view.</source>
        <translation>按住 Shift 时，钻头沿视线方向直行。</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>钻孔</translation>
    </message>
    <message>
        <source>Hold the left button: the drill goes on at its feed, and the plots show thrust and torque. Let go as soon as the breakthrough is shown.</source>
        <translation>按住左键：钻头以其进给前进，曲线图显示轴向力和扭矩。一旦显示已钻穿，请立即松开。</translation>
    </message>
    <message>
        <source>The thrust falls when the tip comes through the inner table.</source>
        <translation>钻尖穿过颅骨内板时，轴向力下降。</translation>
    </message>
    <message>
        <source>Ctrl+Z takes a hole back, and with it all that was measured of it.</source>
        <translation>Ctrl+Z 撤销一个孔，连同其全部测量数据。</translation>
    </message>
    <message>
        <source>Measure the hole</source>
        <translation>测量孔</translation>
    </message>
    <message>
        <source>Press “Measure” below.</source>
        <translation>按下方的“测量”。</translation>
    </message>
    <message>
        <source>The brain is not touched</source>
        <translation>未触及大脑</translation>
    </message>
    <message>
        <source>Stopped within 2 mm</source>
        <translation>在 2 mm 以内停止</translation>
    </message>
    <message>
        <source>On the planned path</source>
        <translation>沿规划路径</translation>
    </message>
    <message>
        <source>Through within 20 s</source>
        <translation>20 s 以内钻穿</translation>
    </message>
    <message>
        <source>Thrust below 30 N</source>
        <translation>轴向力低于 30 N</translation>
    </message>
    <message>
        <source>Gentle in the last millimetre</source>
        <translation>最后一毫米轻柔</translation>
    </message>
    <message>
        <source>Torque below 150 N·mm</source>
        <translation>扭矩低于 150 N·mm</translation>
    </message>
    <message>
        <source>Cool drilling</source>
        <translation>低温钻孔</translation>
    </message>
    <message>
        <source>Part off</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>Part the glass off below its foot.</source>
        <translation>在杯脚下方把酒杯切断。</translation>
    </message>
    <message>
        <source>Straight in to the axis, at a small feed.</source>
        <translation>以小进给直切到轴线。</translation>
    </message>
    <message>
        <source>boring bar</source>
        <translation>镗刀</translation>
    </message>
    <message>
        <source>parting tool</source>
        <translation>切断刀</translation>
    </message>
    <message>
        <source>threading tool of 60°</source>
        <translation>60° 螺纹车刀</translation>
    </message>
    <message>
        <source>On the lathe, drill first: a boring bar needs a hole to begin in.</source>
        <translation>在车床上请先钻孔：镗刀需要从已有的孔开始。</translation>
    </message>
    <message>
        <source>Z in the label is the place of the face that the tool leaves, from the finished end of the bar: stop at Z -30.</source>
        <translation>标签中的 Z 是刀具所留下端面的位置，从棒料的完工端面算起：请在 Z -30 处停止。</translation>
    </message>
</context>
<context>
    <name>ExpressionText</name>
    <message>
        <source>A number is missing</source>
        <translation>缺少数字</translation>
    </message>
    <message>
        <source>A number is missing at the end</source>
        <translation>末尾缺少数字</translation>
    </message>
    <message>
        <source>A number is missing before “%1”</source>
        <translation>“%1”前缺少数字</translation>
    </message>
    <message>
        <source>A closing bracket is missing at the end</source>
        <translation>末尾缺少右括号</translation>
    </message>
    <message>
        <source>A closing bracket is missing before “%1”</source>
        <translation>“%1”前缺少右括号</translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation>“%1”不是数字</translation>
    </message>
    <message>
        <source>“%1” can be read in two ways; write it with a point, or without the comma</source>
        <translation>“%1”有两种读法；请用小数点，或去掉逗号</translation>
    </message>
    <message>
        <source>Lengths, angles and plain numbers cannot be added to each other</source>
        <translation>长度、角度与纯数之间不能相加</translation>
    </message>
    <message>
        <source>The result has the wrong unit</source>
        <translation>结果的单位不对</translation>
    </message>
    <message>
        <source>The result is too large</source>
        <translation>结果过大</translation>
    </message>
    <message>
        <source>%1 (character %2).</source>
        <translation>%1（第 %2 个字符）。</translation>
    </message>
    <message>
        <source>The expression is too long</source>
        <translation>表达式过长</translation>
    </message>
    <message>
        <source>The brackets are nested too deeply</source>
        <translation>括号嵌套过深</translation>
    </message>
    <message>
        <source>An operator such as + or * is missing before “%1”</source>
        <translation>“%1”前缺少运算符，例如 + 或 *</translation>
    </message>
    <message>
        <source>“%1” is not a known unit</source>
        <translation>“%1”不是已知单位</translation>
    </message>
    <message>
        <source>Division by zero</source>
        <translation>除数为零</translation>
    </message>
</context>
<context>
    <name>FaceMateTool</name>
    <message>
        <source>Lay %1 on a face</source>
        <translation>将 %1 贴放到面上</translation>
    </message>
</context>
<context>
    <name>Fidelity</name>
    <message>
        <source>share of the diagonal</source>
        <translation>对角线的比例</translation>
    </message>
    <message>
        <source>Method that fills holes</source>
        <translation>填补孔洞的方法</translation>
    </message>
    <message>
        <source>ear</source>
        <translation>耳切</translation>
    </message>
    <message>
        <source>minimal</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>细化</translation>
    </message>
    <message>
        <source>fair</source>
        <translation>光顺</translation>
    </message>
    <message>
        <source>RMS distance of the patch from the surface</source>
        <translation>补片到曲面的均方根距离</translation>
    </message>
    <message>
        <source>% of the hole</source>
        <translation>孔洞的 %</translation>
    </message>
    <message>
        <source>CPU time of a fill</source>
        <translation>一次填补的 CPU 时间</translation>
    </message>
    <message>
        <source>memory of an undo step</source>
        <translation>一个撤销步骤的内存</translation>
    </message>
    <message>
        <source>CPU time to take, undo and redo a step</source>
        <translation>执行、撤销和重做一步的 CPU 时间</translation>
    </message>
    <message>
        <source>draw calls of a frame</source>
        <translation>每帧绘制调用</translation>
    </message>
    <message>
        <source>calls</source>
        <translation>次</translation>
    </message>
    <message>
        <source>largest distance of the triangles from the surface</source>
        <translation>三角形到曲面的最大距离</translation>
    </message>
    <message>
        <source>CPU time of a tessellation</source>
        <translation>一次三角化的 CPU 时间</translation>
    </message>
    <message>
        <source>area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>dihedral</source>
        <translation>二面角</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>棱线</translation>
    </message>
    <message>
        <source>Edges of a hole that is filled in one piece</source>
        <translation>整块填补的孔洞的边数</translation>
    </message>
    <message>
        <source>Triangles that a slow display draws while the view moves</source>
        <translation>视图移动时慢速显示绘制的三角形数</translation>
    </message>
    <message>
        <source>largest distance from the mesh, in diagonals</source>
        <translation>到网格的最大距离(对角线的比例)</translation>
    </message>
    <message>
        <source>triangles of a frame</source>
        <translation>每帧三角形数</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>个三角形</translation>
    </message>
    <message>
        <source>Sides of the round shapes of robots</source>
        <translation>机器人圆形体的边数</translation>
    </message>
    <message>
        <source>largest distance of the triangles from the shape, in radii</source>
        <translation>三角形到形体的最大距离(半径的比例)</translation>
    </message>
    <message>
        <source>triangles of a shape</source>
        <translation>一个形体的三角形数</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>tangent</source>
        <translation>切线</translation>
    </message>
    <message>
        <source>curvature</source>
        <translation>曲率</translation>
    </message>
    <message>
        <source>Snap distance</source>
        <translation>捕捉距离</translation>
    </message>
    <message>
        <source>distances between features</source>
        <translation>特征间距</translation>
    </message>
    <message>
        <source>CPU time of a tick</source>
        <translation>每个节拍的 CPU 时间</translation>
    </message>
    <message>
        <source>RMS difference from the sum of all forces</source>
        <translation>与全部力之和的均方根偏差</translation>
    </message>
    <message>
        <source>Tolerance of the contact point</source>
        <translation>接触点的公差</translation>
    </message>
    <message>
        <source>diagonals of the model</source>
        <translation>模型对角线</translation>
    </message>
    <message>
        <source>Rate of the servo loop</source>
        <translation>伺服循环的频率</translation>
    </message>
    <message>
        <source>CPU time of a second of touch</source>
        <translation>每秒触摸的 CPU 时间</translation>
    </message>
    <message>
        <source>Stiffness of surfaces</source>
        <translation>表面刚度</translation>
    </message>
    <message>
        <source>rate of the servo loop that keeps it stable</source>
        <translation>保持其稳定的伺服循环频率</translation>
    </message>
    <message>
        <source>Velocity window</source>
        <translation>速度窗口</translation>
    </message>
    <message>
        <source>RMS error of the velocity</source>
        <translation>速度的均方根误差</translation>
    </message>
    <message>
        <source>CPU time of cutting and of the triangles that change</source>
        <translation>一次切削及其变化三角形的 CPU 时间</translation>
    </message>
    <message>
        <source>largest distance from the surface, in diagonals</source>
        <translation>到曲面的最大距离（以对角线计）</translation>
    </message>
    <message>
        <source>triangles of the mesh</source>
        <translation>网格的三角形数</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Deviation of triangles from the surfaces of a STEP file to aim at</source>
        <translation>三角形相对 STEP 文件曲面的目标偏差</translation>
    </message>
    <message>
        <source>penetration at 2 N into the stiffest wall that the rate allows</source>
        <translation>在该速率允许的最大刚度下，2 N 力的压入深度</translation>
    </message>
    <message>
        <source>penetration at 2 N into the surface</source>
        <translation>2 N 力压入表面的深度</translation>
    </message>
    <message>
        <source>delay of the velocity</source>
        <translation>速度的延迟</translation>
    </message>
    <message>
        <source>features missed by a trembling hand</source>
        <translation>手抖时错过的特征</translation>
    </message>
    <message>
        <source>Features that attract at the same time</source>
        <translation>同时产生吸引的特征</translation>
    </message>
    <message>
        <source>Sample spacing of a turned profile</source>
        <translation>车削轮廓的采样间距</translation>
    </message>
    <message>
        <source>largest distance of the profile from the exact shape</source>
        <translation>轮廓与精确形状的最大距离</translation>
    </message>
    <message>
        <source>Distance below which boundary vertices are merged</source>
        <translation>小于此距离的边界顶点将被合并</translation>
    </message>
    <message>
        <source>boundary vertices left unmerged or merged wrongly</source>
        <translation>未合并或误合并的边界顶点</translation>
    </message>
    <message>
        <source>CPU time to merge the boundary vertices</source>
        <translation>合并边界顶点的 CPU 时间</translation>
    </message>
    <message>
        <source>Continuity of fair patches with their surroundings</source>
        <translation>光顺补片与周围的连续性</translation>
    </message>
    <message>
        <source>Density of patches, relative to their surroundings</source>
        <translation>补片密度，相对于周围</translation>
    </message>
    <message>
        <source>Largest distance from the original when triangles are reduced</source>
        <translation>减少三角形时与原始网格的最大距离</translation>
    </message>
    <message>
        <source>remaining triangles</source>
        <translation>剩余三角形</translation>
    </message>
    <message>
        <source>Vertices or triangles in a block of an undo step</source>
        <translation>撤销步骤每块的顶点或三角形数</translation>
    </message>
    <message>
        <source>Triangles in a block of the display</source>
        <translation>显示中每块的三角形数</translation>
    </message>
    <message>
        <source>CPU time to rebuild the blocks that an edit of one triangle affects</source>
        <translation>编辑一个三角形后重建受影响的块的 CPU 时间</translation>
    </message>
    <message>
        <source>Largest deviation of triangles from a curved surface</source>
        <translation>三角形相对曲面的最大偏差</translation>
    </message>
    <message>
        <source>RMS distance from its final position</source>
        <translation>与最终位置的均方根距离</translation>
    </message>
    <message>
        <source>Method of reducing triangles</source>
        <translation>减少三角形的方法</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>有界</translation>
    </message>
    <message>
        <source>quadric</source>
        <translation>二次误差</translation>
    </message>
    <message>
        <source>CPU time to remove triangles</source>
        <translation>移除三角形的 CPU 时间</translation>
    </message>
    <message>
        <source>Law of the cutting force</source>
        <translation>切削力定律</translation>
    </message>
    <message>
        <source>largest difference from the cited tables</source>
        <translation>与所引表格的最大差异</translation>
    </message>
    <message>
        <source>CPU time of one force</source>
        <translation>计算一次力的 CPU 时间</translation>
    </message>
    <message>
        <source>Method of cutting a turned profile</source>
        <translation>车削轮廓的切削方法</translation>
    </message>
    <message>
        <source>Distance of the control points of a turned profile</source>
        <translation>车削轮廓控制点的间距</translation>
    </message>
    <message>
        <source>Tolerance of the distances that are felt</source>
        <translation>所感受距离的公差</translation>
    </message>
    <message>
        <source>largest error of a distance</source>
        <translation>距离的最大误差</translation>
    </message>
    <message>
        <source>CPU time of a query</source>
        <translation>一次查询的 CPU 时间</translation>
    </message>
    <message>
        <source>Step of the simulation of a lathe</source>
        <translation>车床仿真的步长</translation>
    </message>
    <message>
        <source>CPU time of a second of cutting</source>
        <translation>每秒切削的 CPU 时间</translation>
    </message>
    <message>
        <source>Resolution of the proof that a motion is free</source>
        <translation>证明运动无碰撞的分辨率</translation>
    </message>
    <message>
        <source>CPU time to prove a motion free</source>
        <translation>证明一个运动无碰撞的 CPU 时间</translation>
    </message>
    <message>
        <source>Attempts to make a planned path shorter</source>
        <translation>缩短已规划路径的尝试次数</translation>
    </message>
    <message>
        <source>mean length of paths beyond the shortest one known</source>
        <translation>路径超出已知最短路径的平均长度</translation>
    </message>
    <message>
        <source>CPU time to plan a path and make it shorter</source>
        <translation>规划并缩短一条路径的 CPU 时间</translation>
    </message>
    <message>
        <source>Tolerance of inverse kinematics by iteration</source>
        <translation>迭代法逆运动学的公差</translation>
    </message>
    <message>
        <source>largest distance of the flange from its pose</source>
        <translation>法兰与其位姿的最大距离</translation>
    </message>
    <message>
        <source>CPU time of a solution</source>
        <translation>求一个解的 CPU 时间</translation>
    </message>
    <message>
        <source>collision-free motions near obstacles that are rejected</source>
        <translation>障碍物附近的无碰撞运动中被拒绝的部分</translation>
    </message>
    <message>
        <source>Step of the checks of motions that are not proven free</source>
        <translation>检查未证明无碰撞的运动时的步长</translation>
    </message>
    <message>
        <source>colliding motions that checks at this step alone miss</source>
        <translation>仅按此步长检查会漏掉的碰撞运动</translation>
    </message>
    <message>
        <source>CPU time to check a motion</source>
        <translation>检查一个运动的 CPU 时间</translation>
    </message>
    <message>
        <source>Voxels along the largest extent of a part</source>
        <translation>沿零件最大尺寸方向的体素数</translation>
    </message>
    <message>
        <source>largest distance of the surface from the part, in extents</source>
        <translation>表面与零件的最大距离（以零件最大尺寸计）</translation>
    </message>
    <message>
        <source>CPU time to make the volume and its surface</source>
        <translation>生成体素模型及其表面的 CPU 时间</translation>
    </message>
    <message>
        <source>How voxels are sampled</source>
        <translation>体素的采样方式</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>largest distance of the surface from the part, in voxels</source>
        <translation>表面与零件的最大距离（以体素计）</translation>
    </message>
    <message>
        <source>CPU time to make the volume</source>
        <translation>生成体素模型的 CPU 时间</translation>
    </message>
    <message>
        <source>Voxels that a repair by volume may move the surface by to save triangles</source>
        <translation>体素修复为减少三角形可将表面移动的体素数</translation>
    </message>
    <message>
        <source>How a volume becomes triangles</source>
        <translation>体素模型转换为三角形的方法</translation>
    </message>
    <message>
        <source>marching</source>
        <translation>移动立方体</translation>
    </message>
    <message>
        <source>dual</source>
        <translation>对偶轮廓</translation>
    </message>
    <message>
        <source>RMS distance of edges from the surface, in voxels</source>
        <translation>边到表面的均方根距离（以体素计）</translation>
    </message>
    <message>
        <source>CPU time to make the triangles</source>
        <translation>生成三角形的 CPU 时间</translation>
    </message>
    <message>
        <source>What a voxel loses to a drill in a cycle, in lengths of its way</source>
        <translation>体素在一个周期内被钻头去除的量（以钻头行程的长度计）</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>RMS error of the thrust</source>
        <translation>轴向力的均方根误差</translation>
    </message>
    <message>
        <source>CPU time of a cycle</source>
        <translation>每个周期的 CPU 时间</translation>
    </message>
    <message>
        <source>Cells of a volume along a piece of its display</source>
        <translation>体积显示的每一块沿边的单元数</translation>
    </message>
    <message>
        <source>CPU time to renew the pieces that a touch of clay changes</source>
        <translation>更新一次塑泥所改变的显示块所需的 CPU 时间</translation>
    </message>
</context>
<context>
    <name>FidelityPanel</name>
    <message>
        <source>%1 % of a processor core for the servo loop</source>
        <translation>伺服循环占用一个处理器核心的 %1 %</translation>
    </message>
    <message>
        <source>%1 % of a servo tick (%2 µs)</source>
        <translation>伺服节拍（%2 µs）的 %1 %</translation>
    </message>
    <message>
        <source>%1 % of the servo rate for stiffness</source>
        <translation>刚度占用伺服频率的 %1 %</translation>
    </message>
    <message>
        <source>%1 % of a frame (%2 ms)</source>
        <translation>一帧（%2 ms）的 %1 %</translation>
    </message>
    <message>
        <source>%1 % of a second for a repair</source>
        <translation>一次修复占用一秒的 %1 %</translation>
    </message>
    <message>
        <source>%1 % of a second for a fill</source>
        <translation>一次填补占用一秒的 %1 %</translation>
    </message>
    <message>
        <source>Most accurate value that leaves a third of the limit unused. Takes %1.</source>
        <translation>在留出三分之一余量的前提下最精确的值。占用 %1。</translation>
    </message>
    <message>
        <source>%1: no value is fast enough, the fastest is used.</source>
        <translation>%1：没有足够快的值，采用最快的值。</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Time of the work</source>
        <translation>作业时间</translation>
    </message>
    <message>
        <source>Hints looked at</source>
        <translation>查看提示次数</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Diameter of a bore</source>
        <translation>孔径</translation>
    </message>
    <message>
        <source>Length between two faces</source>
        <translation>两端面间的长度</translation>
    </message>
    <message>
        <source>Depth of a bore to a face</source>
        <translation>孔到端面的深度</translation>
    </message>
    <message>
        <source>Radius of an arc</source>
        <translation>圆弧半径</translation>
    </message>
    <message>
        <source>Radius of an arc inside</source>
        <translation>内圆弧半径</translation>
    </message>
    <message>
        <source>Angle of a taper to the axis</source>
        <translation>锥面与轴线的夹角</translation>
    </message>
    <message>
        <source>Largest deviation from the target</source>
        <translation>与目标的最大偏差</translation>
    </message>
    <message>
        <source>Roughness Ra</source>
        <translation>粗糙度 Ra</translation>
    </message>
    <message>
        <source>Roughness Ra inside</source>
        <translation>内表面粗糙度 Ra</translation>
    </message>
    <message>
        <source>Largest resultant force</source>
        <translation>最大切削合力</translation>
    </message>
    <message>
        <source>Largest motor power</source>
        <translation>最大电机功率</translation>
    </message>
    <message>
        <source>Time of all passes</source>
        <translation>全部走刀的时间</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>孔</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Path of the tool</source>
        <translation>刀具路径</translation>
    </message>
    <message>
        <source>Centre of the nose</source>
        <translation>刀尖圆弧中心</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>车削</translation>
    </message>
    <message>
        <source>Resultant force</source>
        <translation>切削合力</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>电机功率</translation>
    </message>
    <message>
        <source>Pitch of a thread</source>
        <translation>螺纹螺距</translation>
    </message>
    <message>
        <source>Major diameter of a thread</source>
        <translation>螺纹大径</translation>
    </message>
    <message>
        <source>Pitch diameter of a thread</source>
        <translation>螺纹中径</translation>
    </message>
    <message>
        <source>Minor diameter of a thread</source>
        <translation>螺纹小径</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>粗糙度</translation>
    </message>
    <message>
        <source>Material left over the target</source>
        <translation>超出目标的余料</translation>
    </message>
    <message>
        <source>Cut too deep</source>
        <translation>切削过深</translation>
    </message>
    <message>
        <source>Collisions and feeds too high</source>
        <translation>碰撞与进给过大</translation>
    </message>
    <message>
        <source>Breakthrough</source>
        <translation>钻穿</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>轴向力</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>扭矩</translation>
    </message>
    <message>
        <source>Depth of the tip</source>
        <translation>钻尖深度</translation>
    </message>
    <message>
        <source>Beside the path</source>
        <translation>偏离路径</translation>
    </message>
    <message>
        <source>Temperature rise (estimate)</source>
        <translation>温升（估计值）</translation>
    </message>
    <message>
        <source>Deviation from the planned path</source>
        <translation>与规划路径的偏差</translation>
    </message>
    <message>
        <source>Time from contact to breakthrough</source>
        <translation>从接触到钻穿的时间</translation>
    </message>
    <message>
        <source>Plunge beyond the inner surface</source>
        <translation>越过内表面的突入量</translation>
    </message>
    <message>
        <source>Depth in the forbidden region</source>
        <translation>进入禁区的深度</translation>
    </message>
    <message>
        <source>Largest thrust</source>
        <translation>最大轴向力</translation>
    </message>
    <message>
        <source>Mean thrust in the last millimetre</source>
        <translation>最后一毫米的平均轴向力</translation>
    </message>
    <message>
        <source>Largest torque</source>
        <translation>最大扭矩</translation>
    </message>
    <message>
        <source>Time of the hole</source>
        <translation>钻孔用时</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>钻孔</translation>
    </message>
    <message>
        <source>Thrust reference (He 2008)</source>
        <translation>轴向力参考值 (He 2008)</translation>
    </message>
    <message>
        <source>Torque reference (He 2008)</source>
        <translation>扭矩参考值 (He 2008)</translation>
    </message>
    <message>
        <source>Diameter at an end of a taper</source>
        <translation>锥面一端的直径</translation>
    </message>
    <message>
        <source>Length of a taper</source>
        <translation>锥面长度</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>尝试次数</translation>
    </message>
    <message>
        <source>Z from the finished face</source>
        <translation>从完工端面算起的 Z</translation>
    </message>
    <message>
        <source>Z from the free end of the bar</source>
        <translation>从棒料自由端算起的 Z</translation>
    </message>
</context>
<context>
    <name>FileFilters</name>
    <message>
        <source>All files</source>
        <translation>所有文件</translation>
    </message>
    <message>
        <source>Handwheel documents</source>
        <translation>Handwheel 文档</translation>
    </message>
    <message>
        <source>All formats</source>
        <translation>所有格式</translation>
    </message>
    <message>
        <source>All supported files</source>
        <translation>所有支持的文件</translation>
    </message>
</context>
<context>
    <name>HandGuidingTool</name>
    <message>
        <source>Lead the robot</source>
        <translation>引导机器人</translation>
    </message>
    <message>
        <source>Pull place %1 of %2</source>
        <translation>拉动 %2 的位置 %1</translation>
    </message>
</context>
<context>
    <name>HapticSession</name>
    <message>
        <source>Simulated hand</source>
        <translation>模拟手</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>无法打开 %1</translation>
    </message>
    <message>
        <source>%1 has failed</source>
        <translation>%1 出现故障</translation>
    </message>
    <message>
        <source>Mouse as device</source>
        <translation>鼠标作为设备</translation>
    </message>
    <message>
        <source>%1 is not connected</source>
        <translation>%1 未连接</translation>
    </message>
    <message>
        <source>It does not respond correctly.</source>
        <translation>设备未正确响应。</translation>
    </message>
    <message>
        <source>A device plugin could not be loaded</source>
        <translation>无法加载设备插件</translation>
    </message>
    <message>
        <source>It does not answer any more.</source>
        <translation>它不再响应。</translation>
    </message>
    <message>
        <source>Plug it in and switch it on. If it is not opened automatically then, press “Open again”.</source>
        <translation>请连接并打开设备电源。如果之后没有自动打开，请按“重新打开”。</translation>
    </message>
    <message>
        <source>Unplug it and plug it in again. If it is not opened automatically then, press “Open again”.</source>
        <translation>拔下设备并重新连接。如果之后没有自动打开，请按“重新打开”。</translation>
    </message>
    <message>
        <source>Open again</source>
        <translation>重新打开</translation>
    </message>
    <message>
        <source>Simulated hand with torque</source>
        <translation>带力矩的模拟手</translation>
    </message>
</context>
<context>
    <name>HelpPages</name>
    <message>
        <source>Keys and mouse</source>
        <translation>按键与鼠标</translation>
    </message>
    <message>
        <source>About Handwheel</source>
        <translation>关于 Handwheel</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public Licence, version 3 or later.&lt;br&gt;Built with Qt, VTK, CGAL, Open CASCADE, Eigen, libzip and expat.</source>
        <translation>自由软件,遵循 GNU 通用公共许可证第 3 版或更高版本。&lt;br&gt;使用 Qt、VTK、CGAL、Open CASCADE、Eigen、libzip 和 expat 构建。</translation>
    </message>
    <message>
        <source>Currently available</source>
        <translation>当前可用</translation>
    </message>
    <message>
        <source>Repairs scanned meshes, shapes and drills volumes, turns workpieces, plans robot cells, and sets and marks exercises.</source>
        <translation>修复扫描网格，塑造体素模型并钻孔，车削工件，规划机器人单元，布置并评分练习。</translation>
    </message>
</context>
<context>
    <name>IkSolutionText</name>
    <message>
        <source>Shoulder in front</source>
        <translation>肩部在前</translation>
    </message>
    <message>
        <source>Shoulder behind</source>
        <translation>肩部在后</translation>
    </message>
    <message>
        <source>Shoulder left</source>
        <translation>肩部在左</translation>
    </message>
    <message>
        <source>Shoulder right</source>
        <translation>肩部在右</translation>
    </message>
    <message>
        <source>elbow up</source>
        <translation>肘部向上</translation>
    </message>
    <message>
        <source>elbow down</source>
        <translation>肘部向下</translation>
    </message>
    <message>
        <source>wrist flipped</source>
        <translation>腕部翻转</translation>
    </message>
    <message>
        <source>wrist not flipped</source>
        <translation>腕部未翻转</translation>
    </message>
    <message>
        <source>%1 beyond its limits</source>
        <translation>%1 超出限位</translation>
    </message>
    <message>
        <source>collides: %1 with %2</source>
        <translation>碰撞：%1 与 %2</translation>
    </message>
    <message>
        <source>Way %1</source>
        <translation>方式 %1</translation>
    </message>
    <message>
        <source>free</source>
        <translation>无碰撞</translation>
    </message>
    <message>
        <source>turned off by %1°</source>
        <translation>偏转 %1°</translation>
    </message>
</context>
<context>
    <name>IkSolutionsTool</name>
    <message>
        <source>Change the configuration of the arm</source>
        <translation>更改机械臂的位形</translation>
    </message>
    <message>
        <source>Move the tool</source>
        <translation>移动工具</translation>
    </message>
</context>
<context>
    <name>JointDragTool</name>
    <message>
        <source>Pull the arm</source>
        <translation>拖动机械臂</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
</context>
<context>
    <name>KindMenus</name>
    <message>
        <source>No document is open.</source>
        <translation>没有打开的文档。</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>文档</translation>
    </message>
</context>
<context>
    <name>LathePart</name>
    <message>
        <source>Cutting edge</source>
        <translation>切削刃</translation>
    </message>
    <message>
        <source>Tool holder</source>
        <translation>刀杆</translation>
    </message>
    <message>
        <source>Tool post</source>
        <translation>刀架</translation>
    </message>
    <message>
        <source>Compound slide</source>
        <translation>小拖板</translation>
    </message>
    <message>
        <source>Quill</source>
        <translation>套筒</translation>
    </message>
    <message>
        <source>Tailstock</source>
        <translation>尾座</translation>
    </message>
    <message>
        <source>Jaws</source>
        <translation>卡爪</translation>
    </message>
    <message>
        <source>Chuck</source>
        <translation>卡盘</translation>
    </message>
    <message>
        <source>Workpiece</source>
        <translation>工件</translation>
    </message>
    <message>
        <source>These parts must not touch.</source>
        <translation>这些部件不得接触。</translation>
    </message>
    <message>
        <source>The rapid traverse ran into the workpiece.</source>
        <translation>快速移动撞上了工件。</translation>
    </message>
    <message>
        <source>The spindle was at rest.</source>
        <translation>主轴处于静止状态。</translation>
    </message>
    <message>
        <source>The spindle turned backwards.</source>
        <translation>主轴反向旋转。</translation>
    </message>
    <message>
        <source>The cut was deeper than the cutting edge is long.</source>
        <translation>切深超过了切削刃的长度。</translation>
    </message>
    <message>
        <source>There is no such tool.</source>
        <translation>没有这种刀具。</translation>
    </message>
    <message>
        <source>The exercise does not provide this tool.</source>
        <translation>练习未提供此刀具。</translation>
    </message>
    <message>
        <source>The spindle turns. Stop it before you change tools.</source>
        <translation>主轴正在旋转。请先停止主轴再换刀。</translation>
    </message>
    <message>
        <source>There is no room for it here. Move the slides away from the work first.</source>
        <translation>此处空间不够。请先将拖板移离工件。</translation>
    </message>
    <message>
        <source>The cut needed more power than the motor has.</source>
        <translation>切削所需功率超过了电机的功率。</translation>
    </message>
    <message>
        <source>A file, paper or a disk follows the hand, not a program.</source>
        <translation>锉刀、砂纸和砂轮由手操作，不能由程序控制。</translation>
    </message>
    <message>
        <source>Programs cut threads with a point of 60°, which this thread does not have.</source>
        <translation>程序用 60° 的刀尖切削螺纹，而此螺纹不是这种牙型。</translation>
    </message>
    <message>
        <source>The tool cut on a side that it is not made for.</source>
        <translation>刀具在其不适用的一侧切削。</translation>
    </message>
</context>
<context>
    <name>LatheReadout</name>
    <message>
        <source>Kosilova</source>
        <translation>Kosilova</translation>
    </message>
    <message>
        <source>Kienzle</source>
        <translation>Kienzle</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>神经网络</translation>
    </message>
</context>
<context>
    <name>LatheTool</name>
    <message>
        <source>Turning tool, right</source>
        <translation>外圆车刀（右偏刀）</translation>
    </message>
    <message>
        <source>Turning tool, left</source>
        <translation>外圆车刀（左偏刀）</translation>
    </message>
    <message>
        <source>Facing tool</source>
        <translation>端面车刀</translation>
    </message>
    <message>
        <source>Parting tool</source>
        <translation>切断刀</translation>
    </message>
    <message>
        <source>Grooving tool</source>
        <translation>切槽刀</translation>
    </message>
    <message>
        <source>Form tool</source>
        <translation>成形车刀</translation>
    </message>
    <message>
        <source>Threading tool</source>
        <translation>螺纹车刀</translation>
    </message>
    <message>
        <source>Boring bar</source>
        <translation>镗刀</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>钻头</translation>
    </message>
    <message>
        <source>File</source>
        <translation>锉刀</translation>
    </message>
    <message>
        <source>Abrasive paper</source>
        <translation>砂纸</translation>
    </message>
    <message>
        <source>Grinding disk</source>
        <translation>砂轮</translation>
    </message>
</context>
<context>
    <name>MemoryQuestion</name>
    <message>
        <source>Memory for the voxels</source>
        <translation>体素所需内存</translation>
    </message>
    <message>
        <source>The voxels need %1. Make them all the same?</source>
        <translation>体素需要%1。仍要创建吗？</translation>
    </message>
    <message>
        <source>That is more than a quarter, and other programs may become slow. Larger voxels need less.</source>
        <translation>这超过四分之一，其他程序可能变慢。更大的体素需要更少内存。</translation>
    </message>
    <message>
        <source>&amp;Make them</source>
        <translation>创建(&amp;M)</translation>
    </message>
    <message>
        <source>about %1 MB of %2 MB available</source>
        <translation>约 %1 MB（可用 %2 MB）</translation>
    </message>
</context>
<context>
    <name>MeshUi</name>
    <message>
        <source>%1: nothing was changed</source>
        <translation>%1：未作任何更改</translation>
    </message>
    <message>
        <source>Is %1 in millimetres?</source>
        <translation>%1 的单位是毫米吗？</translation>
    </message>
    <message>
        <source>Lengths, such as a wall thickness, depend on it. Change the unit before you repair.</source>
        <translation>壁厚等长度取决于此。请在修复前更改单位。</translation>
    </message>
    <message>
        <source>Change unit…</source>
        <translation>更改单位…</translation>
    </message>
    <message>
        <source>%1: some sheets stay open</source>
        <translation>%1：部分片体保持开放</translation>
    </message>
    <message>
        <source>%1: check what was removed</source>
        <translation>%1：请检查被移除的部分</translation>
    </message>
    <message>
        <source>The mesh cannot be drilled</source>
        <translation>无法在此网格上钻孔</translation>
    </message>
    <message>
        <source>Why: %1.</source>
        <translation>原因：%1。</translation>
    </message>
    <message>
        <source>A volume of the part can be drilled in any case.</source>
        <translation>零件的体素模型总是可以钻孔。</translation>
    </message>
    <message>
        <source>Make a volume</source>
        <translation>生成体素模型</translation>
    </message>
</context>
<context>
    <name>Navigation</name>
    <message>
        <source>Handwheel</source>
        <translation>Handwheel</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>FreeCAD</source>
        <translation>FreeCAD</translation>
    </message>
    <message>
        <source>SolidWorks</source>
        <translation>SolidWorks</translation>
    </message>
    <message>
        <source>Laptop without a middle button</source>
        <translation>无中键的笔记本</translation>
    </message>
    <message>
        <source>Ctrl+</source>
        <translation>Ctrl+</translation>
    </message>
    <message>
        <source>Alt+</source>
        <translation>Alt+</translation>
    </message>
    <message>
        <source>Shift+</source>
        <translation>Shift+</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左键</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中键</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右键</translation>
    </message>
    <message>
        <source>orbit</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
</context>
<context>
    <name>Note</name>
    <message>
        <source>The recordings of the device are not in this file.</source>
        <translation>设备的录制不在此文件中。</translation>
    </message>
    <message>
        <source>The coarser levels of the sculpted patch are not in this file.</source>
        <translation>所雕刻补片的较粗层级未写入此文件。</translation>
    </message>
    <message>
        <source>Solids: %1. Surfaces that belong to none: %2.</source>
        <translation>实体：%1。不属于实体的曲面：%2。</translation>
    </message>
    <message>
        <source>The body &apos;%1&apos; is linked to %2, which is missing; it is shown as it was when it was read.</source>
        <translation>物体“%1”链接到 %2，该文件缺失；按读取时的样子显示。</translation>
    </message>
    <message>
        <source>The body &apos;%1&apos; is linked to %2, which has changed; it is shown as it was before.</source>
        <translation>物体“%1”链接到 %2，该文件已更改；按更改前的样子显示。</translation>
    </message>
    <message>
        <source>1 hidden body (%1) was left out.</source>
        <translation>已略去 1 个隐藏的物体（%1）。</translation>
    </message>
    <message>
        <source>%1 hidden bodies (%2) were left out.</source>
        <translation>已略去 %1 个隐藏的物体（%2）。</translation>
    </message>
    <message>
        <source>The file: %1.</source>
        <translation>文件：%1。</translation>
    </message>
    <message>
        <source>The single precision of the format moved vertices by up to %1 mm; the number of self-intersections may change by that.</source>
        <translation>该格式的单精度使顶点移动了最多 %1 mm；自相交的数量可能因此改变。</translation>
    </message>
    <message>
        <source>The body measures %1 × %2 × %3 mm.</source>
        <translation>物体尺寸为 %1 × %2 × %3 mm。</translation>
    </message>
    <message>
        <source>The body &apos;%1&apos; has a shape that this program does not know (&apos;%2&apos;): it is kept, but cannot be shown. A newer version may know it.</source>
        <translation>物体“%1”的形状为本程序所不识（“%2”）：它被保留，但无法显示。较新的版本也许能识别。</translation>
    </message>
    <message>
        <source>The file contains the robot and the bodies in their current position; it has no joints.</source>
        <translation>文件包含处于当前位置的机器人和物体；没有关节。</translation>
    </message>
    <message>
        <source>The robot is added in its current position, as one mesh: it has no joints and no colours of its own.</source>
        <translation>机器人按当前姿态作为一个网格添加：没有关节，也没有自己的颜色。</translation>
    </message>
    <message>
        <source>It has %1 open edges, %2 edges with more than two triangles, %3 edges with inconsistent orientation and %4 non-manifold vertices.</source>
        <translation>它有 %1 条开放边、%2 条超过两个三角形的边、%3 条方向不一致的边和 %4 个非流形顶点。</translation>
    </message>
    <message>
        <source>A STEP file contains exact surfaces and no mesh: its faces (%1) were triangulated; the triangles are at most about %2 mm from them.</source>
        <translation>STEP 文件包含精确曲面而非网格：其各面（%1）已三角化，三角形与曲面的距离最多约 %2 mm。</translation>
    </message>
    <message>
        <source>Its lengths (%1) were converted to millimetres.</source>
        <translation>其长度（%1）已换算为毫米。</translation>
    </message>
    <message>
        <source>The marks of holes to keep open are not in this file (%1 marked).</source>
        <translation>保持开放的孔洞标记未写入此文件（已标记 %1 个）。</translation>
    </message>
    <message>
        <source>The file contains one valid solid.</source>
        <translation>文件包含一个有效实体。</translation>
    </message>
    <message>
        <source>Rounded to the numbers of this format, %1 more pairs of triangles intersect. 3MF, PLY, OBJ and OFF keep all digits.</source>
        <translation>按此格式的数值舍入后，另有 %1 对三角形相交。3MF、PLY、OBJ 和 OFF 保留全部位数。</translation>
    </message>
    <message>
        <source>The part measures %1 × %2 × %3 mm, if its numbers are millimetres: the file does not say its unit.</source>
        <translation>如果数值以毫米为单位，则部件尺寸为 %1 × %2 × %3 mm：文件未注明单位。</translation>
    </message>
    <message>
        <source>at Z %1 mm</source>
        <translation>在 Z %1 mm 处</translation>
    </message>
    <message>
        <source>the first face is missing</source>
        <translation>缺少第一个端面</translation>
    </message>
    <message>
        <source>the second face is missing</source>
        <translation>缺少第二个端面</translation>
    </message>
    <message>
        <source>between Z %1 and %2 mm</source>
        <translation>在 Z %1 与 %2 mm 之间</translation>
    </message>
    <message>
        <source>there is no arc</source>
        <translation>没有圆弧</translation>
    </message>
    <message>
        <source>the surface is within %1 mm of the circle</source>
        <translation>表面与该圆的偏差不超过 %1 mm</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>%1 秒后</translation>
    </message>
    <message>
        <source>this figure is not known</source>
        <translation>此指标未知</translation>
    </message>
    <message>
        <source>there are too many passes to measure it</source>
        <translation>走刀过多，无法测量</translation>
    </message>
    <message>
        <source>nothing was cut</source>
        <translation>没有切削任何材料</translation>
    </message>
    <message>
        <source>up to %1 µm, at Z %2 mm</source>
        <translation>最大 %1 µm，在 Z %2 mm 处</translation>
    </message>
    <message>
        <source>the exercise has no target</source>
        <translation>练习没有目标</translation>
    </message>
    <message>
        <source>%1 mm too much at Z %2 mm, %3 mm too little at Z %4 mm</source>
        <translation>在 Z %2 mm 处多 %1 mm，在 Z %4 mm 处少 %3 mm</translation>
    </message>
    <message>
        <source>The tool hit the chuck at Z %1 mm, ⌀%2 mm.</source>
        <translation>刀具在 Z %1 mm、⌀%2 mm 处撞上卡盘。</translation>
    </message>
    <message>
        <source>The file does not say its unit of length: taken as 1 mm in DXF, a pixel in SVG.</source>
        <translation>文件未注明长度单位：DXF 按 1 mm 处理，SVG 按像素处理。</translation>
    </message>
    <message>
        <source>Not read from the drawing: %1.</source>
        <translation>未从图中读取：%1。</translation>
    </message>
    <message>
        <source>Faces that are not of revolution were ignored: %1.</source>
        <translation>已忽略非回转面：%1。</translation>
    </message>
    <message>
        <source>%1 is within %2 and %3</source>
        <translation>%1 在 %2 与 %3 之间</translation>
    </message>
    <message>
        <source>%1 is not above %2</source>
        <translation>%1 不大于 %2</translation>
    </message>
    <message>
        <source>%1 is not below %2</source>
        <translation>%1 不小于 %2</translation>
    </message>
    <message>
        <source>%1, without a limit</source>
        <translation>%1，未设限值</translation>
    </message>
    <message>
        <source>it could not be measured</source>
        <translation>无法测量</translation>
    </message>
    <message>
        <source>%1 is %2 below the lower limit, %3</source>
        <translation>%1 比下限 %3 小 %2</translation>
    </message>
    <message>
        <source>%1 is %2 above the upper limit, %3</source>
        <translation>%1 比上限 %3 大 %2</translation>
    </message>
    <message>
        <source>there is no thread along the range</source>
        <translation>该范围内没有螺纹</translation>
    </message>
    <message>
        <source>%1 grooves, each within %2 mm of the pitch</source>
        <translation>%1 条牙槽，各与螺距相差不超过 %2 mm</translation>
    </message>
    <message>
        <source>The rapid traverse ran into the work at Z %1 mm, ⌀%2 mm.</source>
        <translation>快速移动在 Z %1 mm、⌀%2 mm 处撞上工件。</translation>
    </message>
    <message>
        <source>The spindle turned the wrong way at Z %1 mm, ⌀%2 mm.</source>
        <translation>主轴在 Z %1 mm、⌀%2 mm 处旋转方向错误。</translation>
    </message>
    <message>
        <source>The motor could not turn the spindle at Z %1 mm, ⌀%2 mm.</source>
        <translation>在 Z %1 mm、⌀%2 mm 处电机带不动主轴。</translation>
    </message>
    <message>
        <source>Bar ⌀%1 × %2 mm, held by the chuck over %3 mm</source>
        <translation>棒料 ⌀%1 × %2 mm，卡盘夹持长度 %3 mm</translation>
    </message>
    <message>
        <source>Spindle %1 r/min, feed up to %2 mm per revolution</source>
        <translation>主轴 %1 r/min，进给不超过每转 %2 mm</translation>
    </message>
    <message>
        <source>Tool: %1, nose radius %2 mm</source>
        <translation>刀具：%1，刀尖圆弧半径 %2 mm</translation>
    </message>
    <message>
        <source>The rings of the mesh leave their circles by up to %1 mm.</source>
        <translation>网格的各圈偏离其圆最多 %1 mm。</translation>
    </message>
    <message>
        <source>Threads are in the file as their envelope, without grooves: %1.</source>
        <translation>文件中的螺纹只有包络外形，没有牙槽：%1。</translation>
    </message>
    <message>
        <source>there is no arc: the surface is up to %1 mm from any circle</source>
        <translation>没有圆弧：表面与任何圆的偏差达 %1 mm</translation>
    </message>
    <message>
        <source>there is no such surface in the range</source>
        <translation>该范围内没有这样的表面</translation>
    </message>
    <message>
        <source>File: %1</source>
        <translation>文件：%1</translation>
    </message>
    <message>
        <source>Handed in: %1</source>
        <translation>提交时间：%1</translation>
    </message>
    <message>
        <source>Not marked: %1</source>
        <translation>未评分：%1</translation>
    </message>
    <message>
        <source>Time: %1; recorded: %2. Hints looked at: %3.</source>
        <translation>时间：%1；录制：%2。查看提示次数：%3。</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>评分项</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Side by side: %1, %2</source>
        <translation>对照：%1、%2</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>en</source>
        <translation>zh-CN</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 / %2 分</translation>
    </message>
    <message>
        <source>The work is not in the description.</source>
        <translation>作业不在描述文件中。</translation>
    </message>
    <message>
        <source>The numbered columns are the points of these criteria:</source>
        <translation>带编号的各列为以下评分项的得分：</translation>
    </message>
    <message>
        <source>Contact.</source>
        <translation>接触。</translation>
    </message>
    <message>
        <source>The drill left the planned path by more than %1 mm.</source>
        <translation>钻头偏离规划路径超过 %1 mm。</translation>
    </message>
    <message>
        <source>Breakthrough: the drill is through the inner surface.</source>
        <translation>钻穿：钻头已穿过内表面。</translation>
    </message>
    <message>
        <source>The drill entered the forbidden region.</source>
        <translation>钻头进入了禁区。</translation>
    </message>
    <message>
        <source>The measuring was cancelled.</source>
        <translation>测量已取消。</translation>
    </message>
    <message>
        <source>The volume was changed by something else than the drill.</source>
        <translation>体素模型被钻头以外的操作更改。</translation>
    </message>
    <message>
        <source>Another drill, speed or material was used.</source>
        <translation>使用了其他钻头、转速或材料。</translation>
    </message>
    <message>
        <source>Nothing was drilled.</source>
        <translation>没有钻任何孔。</translation>
    </message>
    <message>
        <source>The drill did not come through.</source>
        <translation>钻头没有钻穿。</translation>
    </message>
    <message>
        <source>It was entered %1 s after contact.</source>
        <translation>接触后 %1 s 进入。</translation>
    </message>
    <message>
        <source>Twist drill ⌀%1 mm, %2 r/min</source>
        <translation>麻花钻 ⌀%1 mm，%2 r/min</translation>
    </message>
    <message>
        <source>Burr ⌀%1 mm, %2 r/min</source>
        <translation>旋转锉 ⌀%1 mm，%2 r/min</translation>
    </message>
    <message>
        <source>Ball head ⌀%1 mm, %2 r/min</source>
        <translation>球头 ⌀%1 mm，%2 r/min</translation>
    </message>
    <message>
        <source>Material: %1</source>
        <translation>材料：%1</translation>
    </message>
    <message>
        <source>Planned path within %1 mm: the green line</source>
        <translation>规划路径，偏差不超过 %1 mm：绿线</translation>
    </message>
    <message>
        <source>The head must not enter the forbidden region</source>
        <translation>钻头不得进入禁区</translation>
    </message>
    <message>
        <source>The finished face, zero of the drawing and of programs, is %1 mm behind the free end of the bar, at Z %2 mm; %3 mm of the bar are left behind the part at the chuck&apos;s end.</source>
        <translation>完工端面即图纸和程序的零点，位于棒料自由端之后 %1 mm，Z %2 mm 处；零件之后的卡盘端剩余 %3 mm 棒料。</translation>
    </message>
    <message>
        <source>The target, ⌀%1 × %2 mm, does not fit into the bar of ⌀%3 × %4 mm. Set the bar to a larger size, then what is left for facing.</source>
        <translation>目标 ⌀%1 × %2 mm 放不进棒料 ⌀%3 × %4 mm。请先将棒料设为更大的尺寸，再设置端面余量。</translation>
    </message>
    <message>
        <source>A description cannot contain a model solution that was made by hand; it was left out.</source>
        <translation>描述文件无法包含手工完成的参考答案；已将其略去。</translation>
    </message>
    <message>
        <source>Vertices moved apart in the last digits that the file can hold, so that it does not weld them: %1.</source>
        <translation>为避免文件将其合并，在文件所能保存的最末几位数字上分开的顶点：%1。</translation>
    </message>
    <message>
        <source>There is no facing allowance: a part is drilled as it is.</source>
        <translation>没有端面余量：零件按原样钻孔。</translation>
    </message>
    <message>
        <source>The file does not give the spacing of its samples: 1 mm is assumed.</source>
        <translation>文件未给出采样点间距：假定为 1 mm。</translation>
    </message>
    <message>
        <source>Samples that are not numbers were replaced by the smallest value (%1).</source>
        <translation>非数字的采样点已替换为最小值（%1）。</translation>
    </message>
    <message>
        <source>The file contains several values or images (%1); only the first was read.</source>
        <translation>文件包含多个值或图像（%1）；只读取了第一个。</translation>
    </message>
    <message>
        <source>The slices are tilted by %1° against their stacking direction; this was corrected.</source>
        <translation>切片相对其堆叠方向倾斜 %1°；已校正。</translation>
    </message>
    <message>
        <source>Slices of other series were ignored (%1).</source>
        <translation>已忽略其他序列的切片（%1）。</translation>
    </message>
    <message>
        <source>Slices at the position of another slice were ignored (%1).</source>
        <translation>已忽略与其他切片位置重复的切片（%1）。</translation>
    </message>
    <message>
        <source>Files that are damaged, or are not greyscale images, were ignored (%1).</source>
        <translation>已忽略损坏的文件或非灰度图像的文件（%1）。</translation>
    </message>
    <message>
        <source>Values from %1 upwards are taken as material (Otsu&apos;s threshold). Choose any other range in the panel Segmentation or with &apos;handwheel segment&apos;.</source>
        <translation>从 %1 起的值视为材料（大津阈值）。可在“分割”面板中或用“handwheel segment”选择任何其他范围。</translation>
    </message>
    <message>
        <source>The file contains densities: densities above 0.5 are taken as material.</source>
        <translation>文件包含密度：大于 0.5 的密度视为材料。</translation>
    </message>
    <message>
        <source>Other grids of the file were ignored (%1).</source>
        <translation>已忽略文件中的其他网格（%1）。</translation>
    </message>
    <message>
        <source>The drawing is the target of a new bar of ⌀%1 × %2 mm, with %3 mm left for facing at the free end. Enter another size in the panel Stock; for an exercise use Import target… in its panel.</source>
        <translation>该图纸是新棒料 ⌀%1 × %2 mm 的目标，自由端留有 %3 mm 端面余量。可在“毛坯”面板中输入其他尺寸；对于练习，请使用其面板中的“导入目标…”。</translation>
    </message>
    <message>
        <source>The feed was too high at Z %1 mm, ⌀%2 mm: %3 mm per revolution, where at most %4 is allowed.</source>
        <translation>在 Z %1 mm、⌀%2 mm 处进给过大：每转 %3 mm，最大允许 %4。</translation>
    </message>
    <message>
        <source>Parts of the lathe collided at Z %1 mm, ⌀%2 mm.</source>
        <translation>车床部件在 Z %1 mm、⌀%2 mm 处发生碰撞。</translation>
    </message>
    <message>
        <source>The tool was fed into the work at rest at Z %1 mm, ⌀%2 mm.</source>
        <translation>刀具在 Z %1 mm、⌀%2 mm 处进给切入静止的工件。</translation>
    </message>
    <message>
        <source>The cut was deeper than the cutting edge is long at Z %1 mm, ⌀%2 mm.</source>
        <translation>在 Z %1 mm、⌀%2 mm 处切深超过了切削刃的长度。</translation>
    </message>
    <message>
        <source>The cut was too heavy: a resultant force of %1 N, where the lathe takes %2 N.</source>
        <translation>切削过重：切削合力为 %1 N，而车床只能承受 %2 N。</translation>
    </message>
    <message>
        <source>The cut was too heavy: a motor power of %1 kW, where the lathe has %2 kW.</source>
        <translation>切削过重：电机功率为 %1 kW，而车床只有 %2 kW。</translation>
    </message>
    <message>
        <source>there is no such surface along the whole range</source>
        <translation>整个范围内没有这样的表面</translation>
    </message>
    <message>
        <source>the arc curves in the opposite direction</source>
        <translation>圆弧向相反方向弯曲</translation>
    </message>
    <message>
        <source>the marking scheme does not specify where to measure</source>
        <translation>评分标准未指定测量位置</translation>
    </message>
    <message>
        <source>the part does not match its recorded passes</source>
        <translation>零件与其记录的走刀不符</translation>
    </message>
    <message>
        <source>the surface was not cut along the whole range</source>
        <translation>并非整个范围内的表面都经过切削</translation>
    </message>
    <message>
        <source>the tool that cut it has no nose radius, or the feed was larger than that</source>
        <translation>所用刀具没有刀尖圆弧半径，或进给量超过了刀尖圆弧半径</translation>
    </message>
    <message>
        <source>feed too high %1 times, up to %2 mm per revolution where at most %3 is allowed; other collisions: %4</source>
        <translation>进给过快 %1 次，最大达每转 %2 mm，最大允许 %3；其他碰撞：%4</translation>
    </message>
    <message>
        <source>the marking scheme has no limit for it</source>
        <translation>评分标准未给出其限值</translation>
    </message>
    <message>
        <source>no points, because “%1” was not met</source>
        <translation>不得分，因为未达到“%1”</translation>
    </message>
    <message>
        <source>Walls thinner than a voxel (%1 mm) were lost: %2 % of the surface is farther than a voxel from the surface of the volume. Choose smaller voxels.</source>
        <translation>比体素 (%1 mm) 薄的壁已丢失：%2 % 的表面与体积表面的距离超过一个体素。请选择更小的体素。</translation>
    </message>
    <message>
        <source>The part in section.</source>
        <translation>零件剖面。</translation>
    </message>
    <message>
        <source>Rounded to the numbers of this format, %1 more triangles have no area. 3MF, PLY, OBJ and OFF keep all digits; or move the part to the origin.</source>
        <translation>按此格式的数字舍入后，又有 %1 个三角形没有面积。3MF、PLY、OBJ 和 OFF 保留所有位数；或者将零件移到原点。</translation>
    </message>
    <message>
        <source>The hole in section along the planned path. Grey: material that is left. Light blue: drilled. Red: drilled beside the planned hole or in the forbidden region, which is pink. Green: the planned path, with its tolerance. Black: the path of the tip.</source>
        <translation>沿计划路径的孔剖面。灰色：剩余材料。浅蓝色：已钻。红色：钻在计划孔之外或禁区内，禁区为粉色。绿色：计划路径及其公差。黑色：钻尖的路径。</translation>
    </message>
    <message>
        <source>after %1 s; too heavy a cut: the lathe takes %2 N</source>
        <translation>%1 秒后；切削过重：车床可承受 %2 N</translation>
    </message>
    <message>
        <source>after %1 s; too heavy a cut: the lathe has %2 kW</source>
        <translation>%1 秒后；切削过重：车床功率为 %2 kW</translation>
    </message>
    <message>
        <source>%1 of 1 point</source>
        <translation>%1/1 分</translation>
    </message>
    <message>
        <source>Resultant force up to %1 N</source>
        <translation>切削合力不超过 %1 N</translation>
    </message>
    <message>
        <source>Motor power up to %1 kW</source>
        <translation>电机功率不超过 %1 kW</translation>
    </message>
    <message>
        <source>The part in section, with the outline of the target. Blue: material left over the target. Red: cut too deep. The bar behind the part is grey.</source>
        <translation>零件剖面及目标轮廓。蓝色：目标之上剩余的材料。红色：切得过深。零件后面的棒料为灰色。</translation>
    </message>
    <message>
        <source>By hand: programs are not allowed</source>
        <translation>手动：不允许使用程序</translation>
    </message>
    <message>
        <source>The end of ⌀%1 mm is the free one, whose face is finished; the end of ⌀%2 mm is towards the chuck.</source>
        <translation>直径 ⌀%1 mm 的一端为自由端，其端面需加工；直径 ⌀%2 mm 的一端朝向卡盘。</translation>
    </message>
    <message>
        <source>The part is parted off: only the piece at its free end counts.</source>
        <translation>零件已被切断：只计算其自由端的那一块。</translation>
    </message>
    <message>
        <source>The class and its marks are not in the description.</source>
        <translation>班级及其评分不在说明中。</translation>
    </message>
    <message>
        <source>Pictures and curves are not kept: mark the file again to have them here.</source>
        <translation>图片和曲线不予保留：请重新评分该文件以在此显示。</translation>
    </message>
    <message>
        <source>Try %1 entered the forbidden region by %2 mm, and was taken back.</source>
        <translation>第 %1 次尝试进入禁区 %2 mm，随后被撤销。</translation>
    </message>
    <message>
        <source>Tries that entered it and were taken back: %1 of %2, by %3 mm at most.</source>
        <translation>进入禁区后被撤销的尝试：%2 次中有 %1 次，最深 %3 mm。</translation>
    </message>
    <message>
        <source>Tool: %1</source>
        <translation>刀具：%1</translation>
    </message>
    <message>
        <source>The planned path and the forbidden region stay where they are. Adapt them to this volume; a drilled hole can be taken as the path.</source>
        <translation>规划路径和禁区保持原位。请使其适应此体素模型；可将已钻的孔设为路径。</translation>
    </message>
    <message>
        <source>Commands that cut, such as Thread, are allowed</source>
        <translation>允许使用切削命令，例如“螺纹”</translation>
    </message>
    <message>
        <source>the pitch of %1 mm is not that of the thread</source>
        <translation>螺距 %1 mm 不是该螺纹的螺距</translation>
    </message>
    <message>
        <source>These marks do not fit the target, which itself would not meet them: %1. Change or delete them.</source>
        <translation>这些评分项与目标不符，目标本身也不能满足它们：%1。请修改或删除它们。</translation>
    </message>
    <message>
        <source>a twist drill leaves H11 to H12, here +%1 mm: bore or ream a finer hole</source>
        <translation>麻花钻只能达到 H11 至 H12，此处为 +%1 mm：更精的孔请镗削或铰削</translation>
    </message>
    <message>
        <source>The layers are not in this file: they are part of its volume.</source>
        <translation>图层不在此文件中：它们已并入其体积。</translation>
    </message>
    <message>
        <source>The mask is not in this file.</source>
        <translation>遮罩不在此文件中。</translation>
    </message>
    <message>
        <source>The records of the holes are not in this file.</source>
        <translation>孔的记录不在此文件中。</translation>
    </message>
    <message>
        <source>The image and its segment are not in this file.</source>
        <translation>图像及其分割不在此文件中。</translation>
    </message>
    <message>
        <source>The link %1 is %2 m large. Descriptions are in metres: if the mesh is in mm, give it scale=&quot;0.001 0.001 0.001&quot;.</source>
        <translation>连杆%1的尺寸为%2 m。描述文件以米为单位：如果网格以mm为单位，请给它scale=&quot;0.001 0.001 0.001&quot;。</translation>
    </message>
    <message>
        <source>The joint %1 is %2 m from the link before it. Descriptions are in metres: check its origin.</source>
        <translation>关节%1距前一连杆%2 m。描述文件以米为单位：请检查其原点。</translation>
    </message>
    <message>
        <source>Links that touch each other at rest are not checked against each other: %1. Forbid those that must not touch in the list of pairs.</source>
        <translation>静止时相互接触的连杆不互相检查：%1。请在配对列表中禁止不得接触的连杆。</translation>
    </message>
    <message>
        <source>The spacing of the slices varies from %1 to %2 mm; slices every %3 mm were interpolated.</source>
        <translation>切片间距在 %1 至 %2 mm 之间变化；已插值为间距 %3 mm 的切片。</translation>
    </message>
    <message>
        <source>The positions of the slices are not stated: a spacing of %1 mm is assumed. The order of the slices, and so left and right, may be reversed.</source>
        <translation>文件未给出切片的位置：假定间距为 %1 mm。切片的顺序可能相反，因此左右也可能颠倒。</translation>
    </message>
    <message>
        <source>The image is a map of labels (%1): all of them are taken as material. Choose others in the panel Segmentation or with &apos;handwheel segment&apos;.</source>
        <translation>该图像是标签图（%1 个标签）：所有标签均视为材料。可在“分割”面板中或用 &apos;handwheel segment&apos; 选择其他标签。</translation>
    </message>
    <message>
        <source>Slices are missing (%1); they were interpolated from their neighbours, which are up to %2 mm apart. What begins or ends between these is not known.</source>
        <translation>缺少切片（%1）；已由相邻切片插值得到，相邻切片相距最多 %2 mm。在其间开始或结束的结构未知。</translation>
    </message>
    <message>
        <source>Segments overlap in %1 samples, which were given to the last of these segments in the file.</source>
        <translation>分割在 %1 个采样处重叠；这些采样归入文件中最后一个分割。</translation>
    </message>
    <message>
        <source>The file states two different positions or orientations of its samples (sform and qform); the sform was used. Check left and right.</source>
        <translation>文件给出了两种不同的采样位置或方向（sform 和 qform）；已使用 sform。请检查左右。</translation>
    </message>
    <message>
        <source>The body was copied and not linked, as the path of an image often contains the patient&apos;s name.</source>
        <translation>该物体已复制而未链接，因为图像的路径常含有患者姓名。</translation>
    </message>
    <message>
        <source>Material was lost: walls are thinner than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the thinnest %4 mm at (%5). Beside %6 mm² of it half of their thickness or more is gone. Voxels of half the thickness keep a wall.</source>
        <translation>材料已丢失：有壁薄于两个体素（%1 mm），占表面的 %2 %（%3 mm²），最薄处 %4 mm，位于 (%5)。其中 %6 mm² 处缺失了一半或更多的厚度。体素为厚度的一半即可保留壁。</translation>
    </message>
    <message>
        <source>Walls are thinner than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the thinnest %4 mm at (%5): they are not exact. Voxels of half the thickness keep a wall.</source>
        <translation>有壁薄于两个体素（%1 mm），占表面的 %2 %（%3 mm²），最薄处 %4 mm，位于 (%5)：它们不精确。体素为厚度的一半即可保留壁。</translation>
    </message>
    <message>
        <source>Gaps were filled: they are narrower than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the narrowest %4 mm at (%5). Beside %6 mm² of it half of their width or more is filled. Voxels of half the width keep a gap.</source>
        <translation>间隙已被填充：它们窄于两个体素（%1 mm），占表面的 %2 %（%3 mm²），最窄处 %4 mm，位于 (%5)。其中 %6 mm² 处有一半或更多的宽度被填充。体素为宽度的一半即可保留间隙。</translation>
    </message>
    <message>
        <source>Gaps are narrower than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the narrowest %4 mm at (%5): they are not exact. Voxels of half the width keep a gap.</source>
        <translation>有间隙窄于两个体素（%1 mm），占表面的 %2 %（%3 mm²），最窄处 %4 mm，位于 (%5)：它们不精确。体素为宽度的一半即可保留间隙。</translation>
    </message>
    <message>
        <source>This file has the surface of an earlier segment. To write that of the current segment, press “Make surface” and save again.</source>
        <translation>此文件包含先前分割的表面。要写入当前分割的表面，请按“生成表面”后重新保存。</translation>
    </message>
</context>
<context>
    <name>PathStatus</name>
    <message>
        <source>not verified since a robot was moved, added or removed</source>
        <translation>移动、添加或移除机器人后尚未验证</translation>
    </message>
    <message>
        <source>not verified since the path was changed</source>
        <translation>更改路径后尚未验证</translation>
    </message>
    <message>
        <source>not verified since other joints were moved</source>
        <translation>移动其他关节后尚未验证</translation>
    </message>
    <message>
        <source>not verified since the bodies were changed</source>
        <translation>更改物体后尚未验证</translation>
    </message>
    <message>
        <source>not verified since the tool centre point was changed</source>
        <translation>更改工具中心点后尚未验证</translation>
    </message>
    <message>
        <source>not verified since the clearance was changed</source>
        <translation>更改间隙后尚未验证</translation>
    </message>
    <message>
        <source>not verified yet</source>
        <translation>尚未验证</translation>
    </message>
    <message>
        <source>cannot be verified</source>
        <translation>无法验证</translation>
    </message>
    <message>
        <source>line cannot be followed, %1</source>
        <translation>无法沿直线运动，%1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>free, %1</source>
        <translation>无碰撞，%1</translation>
    </message>
    <message>
        <source>line cannot be followed (%1)</source>
        <translation>无法沿直线运动（%1）</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1, clearance %2</source>
        <translation>%1，间隙 %2</translation>
    </message>
    <message>
        <source>free of collisions (%1)</source>
        <translation>无碰撞（%1）</translation>
    </message>
    <message>
        <source>Verified at %1.</source>
        <translation>验证时间：%1。</translation>
    </message>
    <message>
        <source>The straight line to place %1 leaves the reach of the arm or the limits of its joints.</source>
        <translation>到位置 %1 的直线超出机械臂的可达范围或其关节限位。</translation>
    </message>
    <message>
        <source>Every motion is proven free of collisions.</source>
        <translation>已证明每个运动均无碰撞。</translation>
    </message>
    <message>
        <source>Least clearance: %1.</source>
        <translation>最小间隙：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln collision(s)</source>
        <translation>
            <numerusform>%Ln 处碰撞</numerusform>
        </translation>
    </message>
    <message>
        <source>%1; %2 has moved since</source>
        <translation>%1；此后 %2 已移动</translation>
    </message>
    <message>
        <source>too few places</source>
        <translation>位置过少</translation>
    </message>
    <message>
        <source>A path needs at least two places.</source>
        <translation>路径至少需要两个位置。</translation>
    </message>
    <message>
        <source>verifying…</source>
        <translation>正在验证…</translation>
    </message>
    <message>
        <source>The path is being verified.</source>
        <translation>正在验证路径。</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>此前：%1</translation>
    </message>
    <message>
        <source>plan again: %1 has moved</source>
        <translation>请重新规划：%1 已移动</translation>
    </message>
    <message>
        <source>On the way to place %1: %2 with %3</source>
        <translation>前往位置 %1 途中：%2 与 %3</translation>
    </message>
    <message>
        <source>It was never verified: select the path, or choose Verify all paths.</source>
        <translation>从未验证：请选择该路径，或选择“验证所有路径”。</translation>
    </message>
    <message>
        <source>%1, as stored with the cell</source>
        <translation>%1，如单元中所存储</translation>
    </message>
    <message>
        <source>Every motion is proven to keep a clearance of %1.</source>
        <translation>已证明每个运动都至少保持 %1 的间隙。</translation>
    </message>
    <message>
        <source>Plan it again.</source>
        <translation>请重新规划。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln blend(s) will be exact stops, as not every way within their zones is proven free.</source>
        <translation>
            <numerusform>%Ln 处过渡将改为精确停止，因为其区域内并非所有路径都被证明无碰撞。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>too near %Ln time(s)</source>
        <translation>
            <numerusform>%Ln 次过近</numerusform>
        </translation>
    </message>
    <message>
        <source>plan again: the tool centre point was changed</source>
        <translation>需重新规划：工具中心点已更改</translation>
    </message>
    <message>
        <source>plan again: it misses %1</source>
        <translation>需重新规划：未到达 %1</translation>
    </message>
    <message>
        <source>On the way to place %1: %2 only %4 from %3</source>
        <translation>前往位置 %1 途中：%2 距 %3 仅 %4</translation>
    </message>
    <message numerus="yes">
        <source>and %Ln more</source>
        <translation>
            <numerusform>以及另外 %Ln 个</numerusform>
        </translation>
    </message>
    <message>
        <source>It leads along the curve where %1 was when it was planned: the tool does not meet it any more.</source>
        <translation>它沿规划时 %1 所在处的曲线行进：工具已不再与之相遇。</translation>
    </message>
    <message>
        <source>The tool centre point was another one when its curve was planned: that is not met any more.</source>
        <translation>规划曲线时的工具中心点不同：已不再与曲线相遇。</translation>
    </message>
    <message>
        <source>The tool does not come to the target %1 any more: that, or the tool, has moved since.</source>
        <translation>工具不再到达目标 %1：目标或工具此后已移动。</translation>
    </message>
    <message>
        <source>plan again: its robot has moved</source>
        <translation>需重新规划：机器人已移动</translation>
    </message>
    <message>
        <source>Its robot stood elsewhere when its curve was planned: the tool does not meet that any more.</source>
        <translation>规划其曲线时机器人在别处：刀具已不再到达该曲线。</translation>
    </message>
    <message>
        <source>not verified since its configurations were changed</source>
        <translation>自其构型更改后尚未验证</translation>
    </message>
    <message>
        <source>plan again: %1 was changed</source>
        <translation>需重新规划：%1 已更改</translation>
    </message>
    <message>
        <source>%1; not checked: %2</source>
        <translation>%1；未检查：%2</translation>
    </message>
    <message>
        <source>It leads to %1 as that was stored when the path was planned: it was changed since.</source>
        <translation>它通向规划时所存的 %1：此后该构型已更改。</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 与 %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>line cannot be followed</source>
        <translation>无法沿直线运动</translation>
    </message>
    <message>
        <source>not verified since the allowed pairs, or the shapes left out, were changed</source>
        <translation>自允许的配对或略去的形状更改后未验证</translation>
    </message>
    <message>
        <source>free, but touching, %1</source>
        <translation>无碰撞，但有接触，%1</translation>
    </message>
    <message>
        <source>free of collisions, but touching (%1)</source>
        <translation>无碰撞，但有接触（%1）</translation>
    </message>
    <message>
        <source>Estimated cycle time: %1 s.</source>
        <translation>估计循环时间：%1 s。</translation>
    </message>
    <message>
        <source>not proven: the shape of %1 is missing</source>
        <translation>未证明：缺少%1的形状</translation>
    </message>
    <message>
        <source>not proven: CNT</source>
        <translation>未证明：CNT</translation>
    </message>
    <message>
        <source>proven only as far as what is carried is known</source>
        <translation>仅在已知携带物体的范围内得到证明</translation>
    </message>
    <message>
        <source>The controller rounds the corner at place %1 (CNT), and not everything within it is free: set its rounding to 0, or change the places.</source>
        <translation>控制器在位置 %1 处使拐角变圆（CNT），而拐角内并非全部无碰撞：将其圆滑值设为 0，或更改位置。</translation>
    </message>
    <message>
        <source>The proof ends at place %1: &quot;%2&quot; may grip or release something. Say at that place that the robot carries the same as before.</source>
        <translation>证明在位置 %1 处终止：“%2”可能抓取或释放物体。请在该位置指明机器人携带的物体与之前相同。</translation>
    </message>
    <message>
        <source>The shape of %1 (%2) could not be read, so nothing is proven free: leave it out or replace it in the panel Cell.</source>
        <translation>无法读取%1的形状（%2），因此无法证明任何路径无碰撞：请在“单元”面板中略去或代替它。</translation>
    </message>
    <message>
        <source>The shape of %1 (%2) could not be read, and is left out of the proof.</source>
        <translation>无法读取%1的形状（%2），证明中已略去。</translation>
    </message>
    <message>
        <source>The shape of %1 (%2) could not be read, and %3 replaces it.</source>
        <translation>无法读取%1的形状（%2），由%3代替。</translation>
    </message>
    <message>
        <source>%1; left out: %2</source>
        <translation>%1；略去：%2</translation>
    </message>
    <message>
        <source>not verified since what is assumed for the times was changed</source>
        <translation>更改时间假设后未验证</translation>
    </message>
    <message>
        <source>not proven: blend at place %1</source>
        <translation>未证明：位置 %1 处的过渡</translation>
    </message>
    <message>
        <source>Not everything within the blend of the program at place %1 is free: an export writes %2.</source>
        <translation>程序在位置 %1 处的过渡区内并非处处无碰撞：导出时写入 %2。</translation>
    </message>
    <message>
        <source>Not everything within the blend of the program at place %1 is free: an export writes an exact stop.</source>
        <translation>程序在位置 %1 处的过渡区内并非处处无碰撞：导出时写入精确停止。</translation>
    </message>
    <message>
        <source>not verified since its targets or frames were moved</source>
        <translation>目标或坐标系移动后尚未验证</translation>
    </message>
    <message>
        <source>%1 s of it is waiting.</source>
        <translation>其中等待 %1 s。</translation>
    </message>
    <message numerus="yes">
        <source>The time of %Ln line(s) that wait for something is not in it.</source>
        <translation>
            <numerusform>其中不含 %Ln 行等待语句的时间。</numerusform>
        </translation>
    </message>
    <message>
        <source>plan again: the frame %1 has moved</source>
        <translation>需重新规划：坐标系 %1 已移动</translation>
    </message>
    <message>
        <source> (the proof needs %1)</source>
        <translation> （证明需要 %1）</translation>
    </message>
    <message>
        <source>The frame %1, or the tool, has moved since the program was opened: the path leads to where that was. Plan the path again, or open the program again.</source>
        <translation>打开程序后坐标系 %1 或工具已移动：路径通向其原来的位置。请重新规划路径，或重新打开程序。</translation>
    </message>
</context>
<context>
    <name>PlaceBodyTool</name>
    <message>
        <source>Turn %1</source>
        <translation>转动 %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>放置 %1</translation>
    </message>
</context>
<context>
    <name>ProgramRemarks</name>
    <message>
        <source>These lines do not say in which way the arm comes to their poses: %1. The path has the nearest way, and a controller may take another one; give joint values or a configuration.</source>
        <translation>这些行没有说明手臂以何种方式到达其位姿：%1。路径采用最近的方式，控制器可能采用另一种；请给出关节值或构型。</translation>
    </message>
    <message>
        <source>%1, turned by %2°</source>
        <translation>%1，旋转 %2°</translation>
    </message>
    <message>
        <source>The tool centre point of the program is at %1, that of the cell at %2. The arm comes to the same places, but lines and blends are those of the cell&apos;s tool: set the tool centre point of the cell to that of the program, and open it again.</source>
        <translation>程序的工具中心点在 %1，单元的在 %2。手臂到达相同位置，但直线和圆滑过渡按单元的工具计算：请将单元的工具中心点设为程序的，再重新打开。</translation>
    </message>
    <message>
        <source>External axes stand at “%1” in the whole program. The cell does not move them: robot and parts must stand there as they do then. Programs in the same language are written with these axes.</source>
        <translation>外部轴在整个程序中停在“%1”。单元不会移动它们：机器人和零件必须按那时的位置放置。同一语言的程序会连同这些轴一起写出。</translation>
    </message>
    <message>
        <source>The path does not have all that these lines say: %1 (handlers of errors and interrupts, functions, options of motions such as ACC and PTH, speeds that are no numbers). A program that is written from it does not have this either.</source>
        <translation>路径不包含这些行的全部内容：%1（错误和中断的处理程序、函数、ACC 和 PTH 等运动选项、不是数的速度）。由该路径写出的程序也不包含这些内容。</translation>
    </message>
</context>
<context>
    <name>Property</name>
    <message>
        <source>Document</source>
        <translation>文档</translation>
    </message>
    <message>
        <source>Display unit</source>
        <translation>显示单位</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Size in X</source>
        <translation>X 向尺寸</translation>
    </message>
    <message>
        <source>Size in Y</source>
        <translation>Y 向尺寸</translation>
    </message>
    <message>
        <source>Size in Z</source>
        <translation>Z 向尺寸</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>连杆</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>It is kept open.</source>
        <translation>它被保持开放。</translation>
    </message>
    <message>
        <source>It has more edges than allowed.</source>
        <translation>边数超过允许值。</translation>
    </message>
    <message>
        <source>It would take too long for a mesh of this size.</source>
        <translation>对于这样大小的网格，这会花费太长时间。</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Fair</source>
        <translation>光顺</translation>
    </message>
    <message>
        <source>Refined</source>
        <translation>细化</translation>
    </message>
    <message>
        <source>New triangles</source>
        <translation>新三角形</translation>
    </message>
    <message>
        <source>Select by</source>
        <translation>选择方式</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>套索</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>相连</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Size in</source>
        <translation>尺寸单位</translation>
    </message>
    <message>
        <source>Length on the model</source>
        <translation>模型上的长度</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>Brush radius</source>
        <translation>画笔半径</translation>
    </message>
    <message>
        <source>Select through the model</source>
        <translation>穿透选择</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>最大角度</translation>
    </message>
    <message>
        <source>Clipping plane</source>
        <translation>剖切平面</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>平行</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>View cube</source>
        <translation>视图立方体</translation>
    </message>
    <message>
        <source>View direction</source>
        <translation>视线方向</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Lower end at Z</source>
        <translation>下端 Z 坐标</translation>
    </message>
    <message>
        <source>Chord tolerance</source>
        <translation>弦高公差</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Volume (mm³)</source>
        <translation>体积 (mm³)</translation>
    </message>
    <message>
        <source>Surface (mm²)</source>
        <translation>表面积 (mm²)</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>Balanced</source>
        <translation>均衡</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>棱线</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Angle of three points</source>
        <translation>三点角度</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>壁厚</translation>
    </message>
    <message>
        <source>An edge would have more than two triangles.</source>
        <translation>会有边超过两个三角形。</translation>
    </message>
    <message>
        <source>There is no open edge.</source>
        <translation>没有开放边。</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Marked triangles</source>
        <translation>已标记的三角形</translation>
    </message>
    <message>
        <source>There is no island in this hole.</source>
        <translation>此孔洞中没有孤岛。</translation>
    </message>
    <message>
        <source>There is no peninsula in this hole.</source>
        <translation>此孔洞中没有半岛。</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>最大距离</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>角点</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>拖动</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Inflate</source>
        <translation>膨胀</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>压平</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>It would have too many triangles.</source>
        <translation>三角形会过多。</translation>
    </message>
    <message>
        <source>Triangles of the patch</source>
        <translation>补片的三角形</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>层级</translation>
    </message>
    <message>
        <source>Move along X</source>
        <translation>沿 X 移动</translation>
    </message>
    <message>
        <source>Move along Y</source>
        <translation>沿 Y 移动</translation>
    </message>
    <message>
        <source>Move along Z</source>
        <translation>沿 Z 移动</translation>
    </message>
    <message>
        <source>Scale by</source>
        <translation>缩放倍数</translation>
    </message>
    <message>
        <source>Length of the outline</source>
        <translation>轮廓长度</translation>
    </message>
    <message>
        <source>the outline is open</source>
        <translation>轮廓未闭合</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Tangents</source>
        <translation>切线</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>曲率</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>向右</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>向上</translation>
    </message>
    <message>
        <source>Towards you</source>
        <translation>朝向您</translation>
    </message>
    <message>
        <source>X of the device</source>
        <translation>设备的 X</translation>
    </message>
    <message>
        <source>X, inverted</source>
        <translation>X，反向</translation>
    </message>
    <message>
        <source>Y of the device</source>
        <translation>设备的 Y</translation>
    </message>
    <message>
        <source>Y, inverted</source>
        <translation>Y，反向</translation>
    </message>
    <message>
        <source>Z of the device</source>
        <translation>设备的 Z</translation>
    </message>
    <message>
        <source>Z, inverted</source>
        <translation>Z，反向</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Scale (1 fills the view)</source>
        <translation>比例（1 为充满视图）</translation>
    </message>
    <message>
        <source>Force gain</source>
        <translation>力增益</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>死区</translation>
    </message>
    <message>
        <source>Dead zone in rotation</source>
        <translation>转动死区</translation>
    </message>
    <message>
        <source>No button</source>
        <translation>无按钮</translation>
    </message>
    <message>
        <source>Clutch: the tip stays while it is held</source>
        <translation>离合：按住时尖端不动</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>离合</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>触摸</translation>
    </message>
    <message>
        <source>Stiffness (N/mm)</source>
        <translation>刚度 (N/mm)</translation>
    </message>
    <message>
        <source>Damping (N·s/mm)</source>
        <translation>阻尼 (N·s/mm)</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>合并</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适配</translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation>捕捉</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>弹簧</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Quadratic</source>
        <translation>二次</translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation>高斯</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>捕捉</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>One (proxy)</source>
        <translation>单个（代理点）</translation>
    </message>
    <message>
        <source>Sum (force)</source>
        <translation>总和（力）</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>走刀次数</translation>
    </message>
    <message>
        <source>Resistance (N·s/mm)</source>
        <translation>阻力 (N·s/mm)</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>文件缺失</translation>
    </message>
    <message>
        <source>the file has changed since it was read</source>
        <translation>文件自读取后已更改</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>cannot be shown</source>
        <translation>无法显示</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Smooth shading</source>
        <translation>平滑着色</translation>
    </message>
    <message>
        <source>Linked file</source>
        <translation>链接的文件</translation>
    </message>
    <message>
        <source>State of the file</source>
        <translation>文件状态</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Size X</source>
        <translation>尺寸 X</translation>
    </message>
    <message>
        <source>Size Y</source>
        <translation>尺寸 Y</translation>
    </message>
    <message>
        <source>Size Z</source>
        <translation>尺寸 Z</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>圆柱</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>锥</translation>
    </message>
    <message>
        <source>all joints</source>
        <translation>所有关节</translation>
    </message>
    <message>
        <source>Speed not known</source>
        <translation>速度未知</translation>
    </message>
    <message>
        <source>Effort not known</source>
        <translation>力矩未知</translation>
    </message>
    <message>
        <source>Ear clipping</source>
        <translation>耳切法</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Rotate about X</source>
        <translation>绕 X 旋转</translation>
    </message>
    <message>
        <source>Rotate about Y</source>
        <translation>绕 Y 旋转</translation>
    </message>
    <message>
        <source>Rotate about Z</source>
        <translation>绕 Z 旋转</translation>
    </message>
    <message>
        <source>Angle between two faces</source>
        <translation>两面角度</translation>
    </message>
    <message>
        <source>Along a ray</source>
        <translation>沿射线</translation>
    </message>
    <message>
        <source>Largest inscribed sphere</source>
        <translation>最大内切球</translation>
    </message>
    <message>
        <source>Two of the vertices are the same.</source>
        <translation>其中两个顶点相同。</translation>
    </message>
    <message>
        <source>A triangle would be degenerate.</source>
        <translation>会有三角形退化。</translation>
    </message>
    <message>
        <source>The adjacent triangle has the opposite orientation.</source>
        <translation>相邻三角形的方向相反。</translation>
    </message>
    <message>
        <source>It would touch the surface at a single vertex only.</source>
        <translation>它与曲面只会在一个顶点处相接。</translation>
    </message>
    <message>
        <source>It would intersect or touch the part.</source>
        <translation>它会与零件相交或接触。</translation>
    </message>
    <message>
        <source>A triangle would flip or become degenerate.</source>
        <translation>会有三角形翻转或退化。</translation>
    </message>
    <message>
        <source>Wavelength (edges)</source>
        <translation>波长（边数）</translation>
    </message>
    <message>
        <source>Even spacing</source>
        <translation>均匀间距</translation>
    </message>
    <message>
        <source>Dropped onto a vertex</source>
        <translation>放到顶点上时</translation>
    </message>
    <message>
        <source>Add a bridge</source>
        <translation>添加桥接</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>位移</translation>
    </message>
    <message>
        <source>Constrained vertices</source>
        <translation>受限的顶点</translation>
    </message>
    <message>
        <source>Moving further would flip a triangle or tear the surface.</source>
        <translation>继续移动会使三角形翻转或曲面撕裂。</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Number of triangles</source>
        <translation>三角形数量</translation>
    </message>
    <message>
        <source>Preserve sharp edges</source>
        <translation>保留锐边</translation>
    </message>
    <message>
        <source>It is the outer boundary of an open sheet.</source>
        <translation>这是开放曲面的外边界。</translation>
    </message>
    <message>
        <source>No valid patch fits its boundary.</source>
        <translation>没有有效的补片能贴合其边界。</translation>
    </message>
    <message>
        <source>Every patch would intersect the part.</source>
        <translation>任何补片都会与零件相交。</translation>
    </message>
    <message>
        <source>Every patch would bulge out too far.</source>
        <translation>任何补片都会明显鼓出。</translation>
    </message>
    <message>
        <source>No patch fits, perhaps due to narrow triangles along its boundary. “Repair all” removes them.</source>
        <translation>没有补片能贴合，可能因为其边界上有狭窄的三角形。“全部修复”会移除它们。</translation>
    </message>
    <message>
        <source>Sharp edge angle</source>
        <translation>锐边角度</translation>
    </message>
    <message>
        <source>Preserve open edges</source>
        <translation>保留开放边</translation>
    </message>
    <message>
        <source>Prevent self-intersections</source>
        <translation>防止自相交</translation>
    </message>
    <message>
        <source>Area and bending</source>
        <translation>面积与弯折</translation>
    </message>
    <message>
        <source>Minimum area</source>
        <translation>最小面积</translation>
    </message>
    <message>
        <source>Minimum bending</source>
        <translation>最小弯折</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>连续性</translation>
    </message>
    <message>
        <source>Weight of short edges</source>
        <translation>短边权重</translation>
    </message>
    <message>
        <source>Weight of even angles</source>
        <translation>均匀角度权重</translation>
    </message>
    <message>
        <source>Weight of small bends</source>
        <translation>小弯折权重</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>文件的单位</translation>
    </message>
    <message>
        <source>Noise angle</source>
        <translation>噪声角度</translation>
    </message>
    <message>
        <source>Move boundary vertices, too</source>
        <translation>同时移动边界顶点</translation>
    </message>
    <message>
        <source>It has no inner edge to split.</source>
        <translation>内部没有可分割的边。</translation>
    </message>
    <message>
        <source>The precision of the file does not allow finer triangles.</source>
        <translation>文件的精度不允许更细的三角形。</translation>
    </message>
    <message>
        <source>New self-intersections</source>
        <translation>新增自相交</translation>
    </message>
    <message>
        <source>The surface now intersects itself here: undo, or smooth it.</source>
        <translation>曲面在此处出现自相交：请撤销，或对其进行平滑。</translation>
    </message>
    <message>
        <source>Aspect ratio at the boundary</source>
        <translation>边界处的纵横比</translation>
    </message>
    <message>
        <source>Its outer triangles have become long and thin: go back one level.</source>
        <translation>外侧三角形已变得细长：请退回一级。</translation>
    </message>
    <message>
        <source>Rate control</source>
        <translation>速率控制</translation>
    </message>
    <message>
        <source>mm/s per mm</source>
        <translation>每毫米对应的 mm/s</translation>
    </message>
    <message>
        <source>°/s per degree</source>
        <translation>每度对应的 °/s</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>速度与精度</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>Hole boundaries as curves</source>
        <translation>孔洞边界作为曲线</translation>
    </message>
    <message>
        <source>Clip the model</source>
        <translation>剖切模型</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法向</translation>
    </message>
    <message>
        <source>Flip side</source>
        <translation>翻转侧</translation>
    </message>
    <message>
        <source>Bounded</source>
        <translation>有界</translation>
    </message>
    <message>
        <source>Quadric</source>
        <translation>二次误差</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Scheme</source>
        <translation>细分方案</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Loop</translation>
    </message>
    <message>
        <source>√3</source>
        <translation>√3</translation>
    </message>
    <message>
        <source>Butterfly</source>
        <translation>蝶形</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>级数</translation>
    </message>
    <message>
        <source>Noise filter</source>
        <translation>噪声滤波器</translation>
    </message>
    <message>
        <source>Bilateral (preserves edges)</source>
        <translation>双边（保留边缘）</translation>
    </message>
    <message>
        <source>Laplace</source>
        <translation>拉普拉斯</translation>
    </message>
    <message>
        <source>Bending</source>
        <translation>弯曲</translation>
    </message>
    <message>
        <source>This filter does not support degenerate or duplicate triangles or edges.</source>
        <translation>此滤波器不支持退化或重复的三角形或边。</translation>
    </message>
    <message>
        <source>Resulting triangles</source>
        <translation>结果三角形数</translation>
    </message>
    <message>
        <source>However thin, the body of the sheet would intersect the part.</source>
        <translation>无论多薄，片体的实体都会与零件相交。</translation>
    </message>
    <message>
        <source>The numbers of the file cannot show such a thickness.</source>
        <translation>文件的数值无法表示这样的厚度。</translation>
    </message>
    <message>
        <source>A boundary of the sheet is kept open, and a thin body has none.</source>
        <translation>片体有一条边界保持开放，而薄实体没有边界。</translation>
    </message>
    <message>
        <source>Selected triangles</source>
        <translation>已选三角形</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>this figure is not known</source>
        <translation>此指标未知</translation>
    </message>
    <message>
        <source>Measured at</source>
        <translation>测量位置</translation>
    </message>
    <message>
        <source>Tolerance on the drawing</source>
        <translation>图纸公差</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>分数</translation>
    </message>
    <message>
        <source>No points this far beyond</source>
        <translation>超出此量即不得分</translation>
    </message>
    <message>
        <source>Hidden from students</source>
        <translation>对学生隐藏</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>作者</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Time (min)</source>
        <translation>时间 (min)</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>正文</translation>
    </message>
    <message>
        <source>Lathe</source>
        <translation>车床</translation>
    </message>
    <message>
        <source>Spindle speed (r/min)</source>
        <translation>主轴转速 (r/min)</translation>
    </message>
    <message>
        <source>Held by the chuck</source>
        <translation>卡盘夹持长度</translation>
    </message>
    <message>
        <source>Diameter of the chuck</source>
        <translation>卡盘直径</translation>
    </message>
    <message>
        <source>Largest feed (mm per revolution)</source>
        <translation>最大进给 (mm/r)</translation>
    </message>
    <message>
        <source>Largest force (N)</source>
        <translation>最大力 (N)</translation>
    </message>
    <message>
        <source>Motor power (kW)</source>
        <translation>电机功率 (kW)</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>中点</translation>
    </message>
    <message>
        <source>Trainer</source>
        <translation>训练方法</translation>
    </message>
    <message>
        <source>Levenberg-Marquardt</source>
        <translation>Levenberg-Marquardt</translation>
    </message>
    <message>
        <source>BFGS</source>
        <translation>BFGS</translation>
    </message>
    <message>
        <source>Scaled conjugate gradient</source>
        <translation>缩放共轭梯度</translation>
    </message>
    <message>
        <source>Gradient descent with momentum</source>
        <translation>带动量的梯度下降</translation>
    </message>
    <message>
        <source>Gradient descent</source>
        <translation>梯度下降</translation>
    </message>
    <message>
        <source>Feed and radial force</source>
        <translation>进给力和径向力</translation>
    </message>
    <message>
        <source>By depth and nose</source>
        <translation>按切深和刀尖</translation>
    </message>
    <message>
        <source>Constant share</source>
        <translation>固定比例</translation>
    </message>
    <message>
        <source>Laws of the table</source>
        <translation>表中定律</translation>
    </message>
    <message>
        <source>Tool material</source>
        <translation>刀具材料</translation>
    </message>
    <message>
        <source>Carbide</source>
        <translation>硬质合金</translation>
    </message>
    <message>
        <source>High-speed steel</source>
        <translation>高速钢</translation>
    </message>
    <message>
        <source>Read-out in diameter</source>
        <translation>读数以直径显示</translation>
    </message>
    <message>
        <source>Depth limit (0: none)</source>
        <translation>切深限制（0：无）</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>反向间隙</translation>
    </message>
    <message>
        <source>Length in the jaws</source>
        <translation>卡爪夹持长度</translation>
    </message>
    <message>
        <source>Jaws grip inside</source>
        <translation>卡爪内撑</translation>
    </message>
    <message>
        <source>In the tailstock</source>
        <translation>尾座安装</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>顶尖</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>钻头</translation>
    </message>
    <message>
        <source>Tailstock at Z</source>
        <translation>尾座位于 Z</translation>
    </message>
    <message>
        <source>Nominal size</source>
        <translation>公称尺寸</translation>
    </message>
    <message>
        <source>Motor power, kW (0: no limit)</source>
        <translation>电机功率，kW（0：无限制）</translation>
    </message>
    <message>
        <source>Spindle torque, N·m (0: no limit)</source>
        <translation>主轴扭矩，N·m（0：无限制）</translation>
    </message>
    <message>
        <source>Flank wear of the tools</source>
        <translation>刀具后刀面磨损</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>线数</translation>
    </message>
    <message>
        <source>From Z</source>
        <translation>从 Z</translation>
    </message>
    <message>
        <source>To Z</source>
        <translation>到 Z</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>螺距</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Left-hand</source>
        <translation>左旋</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内螺纹</translation>
    </message>
    <message>
        <source>Chips are shown</source>
        <translation>显示切屑</translation>
    </message>
    <message>
        <source>Diameters and heights to</source>
        <translation>直径和高度圆整到</translation>
    </message>
    <message>
        <source>Sharp corners instead of radii up to</source>
        <translation>改为尖角的最大圆角半径</translation>
    </message>
    <message>
        <source>SBL</source>
        <translation>SBL</translation>
    </message>
    <message>
        <source>RRTConnect (OMPL)</source>
        <translation>RRTConnect (OMPL)</translation>
    </message>
    <message>
        <source>PRM (OMPL)</source>
        <translation>PRM (OMPL)</translation>
    </message>
    <message>
        <source>Lazy PRM (OMPL)</source>
        <translation>Lazy PRM (OMPL)</translation>
    </message>
    <message>
        <source>SBL (OMPL)</source>
        <translation>SBL (OMPL)</translation>
    </message>
    <message>
        <source>BiTRRT (OMPL)</source>
        <translation>BiTRRT (OMPL)</translation>
    </message>
    <message>
        <source>BKPIECE (OMPL)</source>
        <translation>BKPIECE (OMPL)</translation>
    </message>
    <message>
        <source>EST (OMPL)</source>
        <translation>EST (OMPL)</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>规划器</translation>
    </message>
    <message>
        <source>Time limit (s)</source>
        <translation>时间限制 (s)</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>捷径次数</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Carried by</source>
        <translation>携带者</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>沿</translation>
    </message>
    <message>
        <source>an edge</source>
        <translation>一条边</translation>
    </message>
    <message>
        <source>a section across X</source>
        <translation>垂直于 X 的截面</translation>
    </message>
    <message>
        <source>a section across Y</source>
        <translation>垂直于 Y 的截面</translation>
    </message>
    <message>
        <source>a section across Z</source>
        <translation>垂直于 Z 的截面</translation>
    </message>
    <message>
        <source>Length from there (0: all)</source>
        <translation>从该处起的长度（0：全部）</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>前倾角</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>侧倾角</translation>
    </message>
    <message>
        <source>Turn about the tool</source>
        <translation>绕工具转角</translation>
    </message>
    <message>
        <source>Free to turn about the tool</source>
        <translation>可绕工具轴自由转动</translation>
    </message>
    <message>
        <source>Distance from the part</source>
        <translation>与零件的距离</translation>
    </message>
    <message>
        <source>Approach and retract</source>
        <translation>接近与退出</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>速度 (mm/s)</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>过渡圆弧</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>nowhere else</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Comes from</source>
        <translation>来自</translation>
    </message>
    <message>
        <source>Goes to</source>
        <translation>前往</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>形体</translation>
    </message>
    <message>
        <source>simplified: keep a clearance</source>
        <translation>已简化：请保持间隙</translation>
    </message>
    <message>
        <source>Tool centre point, on the flange</source>
        <translation>工具中心点（在法兰上）</translation>
    </message>
    <message>
        <source>Place of the path</source>
        <translation>路径的位置</translation>
    </message>
    <message>
        <source>Motion to it</source>
        <translation>到此处的运动</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Speed (%)</source>
        <translation>速度 (%)</translation>
    </message>
    <message>
        <source>First face, at radius</source>
        <translation>第一端面，所在半径</translation>
    </message>
    <message>
        <source>First face, near Z</source>
        <translation>第一端面，靠近 Z</translation>
    </message>
    <message>
        <source>Second face, at radius</source>
        <translation>第二端面，所在半径</translation>
    </message>
    <message>
        <source>Second face, near Z</source>
        <translation>第二端面，靠近 Z</translation>
    </message>
    <message>
        <source>“To Z” must be above “From Z”</source>
        <translation>“到 Z”须大于“从 Z”</translation>
    </message>
    <message>
        <source>the range goes beyond the bar, which begins at Z 0</source>
        <translation>范围超出棒料，棒料从 Z 0 开始</translation>
    </message>
    <message>
        <source>the bar has no face at such a radius</source>
        <translation>棒料在该半径处没有端面</translation>
    </message>
    <message>
        <source>there is no face of the bar near such a Z</source>
        <translation>棒料在该 Z 附近没有端面</translation>
    </message>
    <message>
        <source>Tools that students may mount; none checked: all</source>
        <translation>学生可安装的刀具；均不勾选：全部</translation>
    </message>
    <message>
        <source>PRM, kept for the cell</source>
        <translation>PRM（为单元保留）</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Configuration of the arm</source>
        <translation>机械臂的位形</translation>
    </message>
    <message>
        <source>this pose is out of reach</source>
        <translation>无法到达此位姿</translation>
    </message>
    <message>
        <source>What meets</source>
        <translation>重合之处</translation>
    </message>
    <message>
        <source>The points clicked</source>
        <translation>单击的点</translation>
    </message>
    <message>
        <source>Turn about the normal</source>
        <translation>绕法向转角</translation>
    </message>
    <message>
        <source>The hand leads</source>
        <translation>手引导</translation>
    </message>
    <message>
        <source>The tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Joint by joint</source>
        <translation>逐个关节</translation>
    </message>
    <message>
        <source>Tool to hand</source>
        <translation>工具与手之比</translation>
    </message>
    <message>
        <source>Turns with the hand</source>
        <translation>随手转动</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Felt from</source>
        <translation>开始感受到力的距离</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Path to follow</source>
        <translation>要跟随的路径</translation>
    </message>
    <message>
        <source>something is in the way</source>
        <translation>途中有障碍</translation>
    </message>
    <message>
        <source>a joint is at its limit</source>
        <translation>有关节已到限位</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>By eye</source>
        <translation>仅凭目视</translation>
    </message>
    <message>
        <source>With force</source>
        <translation>有力反馈</translation>
    </message>
    <message>
        <source>With force and fixture</source>
        <translation>有力反馈和虚拟夹具</translation>
    </message>
    <message>
        <source>Best of each kind (RMS, largest, time)</source>
        <translation>各类最佳结果（均方根、最大、时间）</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>移动量</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>转动量</translation>
    </message>
    <message>
        <source>Along X</source>
        <translation>沿 X</translation>
    </message>
    <message>
        <source>Along Y</source>
        <translation>沿 Y</translation>
    </message>
    <message>
        <source>Along Z</source>
        <translation>沿 Z</translation>
    </message>
    <message>
        <source>About X</source>
        <translation>绕 X</translation>
    </message>
    <message>
        <source>About Y</source>
        <translation>绕 Y</translation>
    </message>
    <message>
        <source>About Z</source>
        <translation>绕 Z</translation>
    </message>
    <message>
        <source>Of the cell</source>
        <translation>单元的</translation>
    </message>
    <message>
        <source>Turns about</source>
        <translation>转动中心</translation>
    </message>
    <message>
        <source>Its middle</source>
        <translation>其中心</translation>
    </message>
    <message>
        <source>Its origin</source>
        <translation>其原点</translation>
    </message>
    <message>
        <source>Resolution of the proof</source>
        <translation>证明的分辨率</translation>
    </message>
    <message>
        <source>a drawn curve</source>
        <translation>绘制的曲线</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体素模型</translation>
    </message>
    <message>
        <source>Voxel</source>
        <translation>体素边长</translation>
    </message>
    <message>
        <source>Material (mm³)</source>
        <translation>材料体积 (mm³)</translation>
    </message>
    <message>
        <source>Memory (MB)</source>
        <translation>内存 (MB)</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Unalloyed steel below 0.25 % C, annealed</source>
        <translation>非合金钢，含碳量低于 0.25 %，退火</translation>
    </message>
    <message>
        <source>Unalloyed steel from 0.25 % C, annealed</source>
        <translation>非合金钢，含碳量 0.25 % 及以上，退火</translation>
    </message>
    <message>
        <source>Unalloyed steel below 0.55 % C, quenched and tempered</source>
        <translation>非合金钢，含碳量低于 0.55 %，调质</translation>
    </message>
    <message>
        <source>Unalloyed steel from 0.55 % C, annealed</source>
        <translation>非合金钢，含碳量 0.55 % 及以上，退火</translation>
    </message>
    <message>
        <source>Unalloyed steel from 0.55 % C, quenched and tempered</source>
        <translation>非合金钢，含碳量 0.55 % 及以上，调质</translation>
    </message>
    <message>
        <source>Low-alloy steel, annealed</source>
        <translation>低合金钢，退火</translation>
    </message>
    <message>
        <source>Low-alloy steel, quenched and tempered, 930 MPa</source>
        <translation>低合金钢，调质，930 MPa</translation>
    </message>
    <message>
        <source>Low-alloy steel, quenched and tempered, 1000 MPa</source>
        <translation>低合金钢，调质，1000 MPa</translation>
    </message>
    <message>
        <source>Low-alloy steel, quenched and tempered, 1200 MPa</source>
        <translation>低合金钢，调质，1200 MPa</translation>
    </message>
    <message>
        <source>High-alloy and tool steel, annealed</source>
        <translation>高合金钢和工具钢，退火</translation>
    </message>
    <message>
        <source>High-alloy and tool steel, quenched and tempered</source>
        <translation>高合金钢和工具钢，调质</translation>
    </message>
    <message>
        <source>Stainless steel, ferritic or martensitic</source>
        <translation>不锈钢，铁素体或马氏体</translation>
    </message>
    <message>
        <source>Stainless steel, martensitic</source>
        <translation>不锈钢，马氏体</translation>
    </message>
    <message>
        <source>Stainless steel, austenitic</source>
        <translation>不锈钢，奥氏体</translation>
    </message>
    <message>
        <source>Grey cast iron, ferritic-pearlitic</source>
        <translation>灰铸铁，铁素体-珠光体</translation>
    </message>
    <message>
        <source>Grey cast iron, pearlitic</source>
        <translation>灰铸铁，珠光体</translation>
    </message>
    <message>
        <source>Nodular cast iron, ferritic</source>
        <translation>球墨铸铁，铁素体</translation>
    </message>
    <message>
        <source>Nodular cast iron, pearlitic</source>
        <translation>球墨铸铁，珠光体</translation>
    </message>
    <message>
        <source>Malleable cast iron, ferritic</source>
        <translation>可锻铸铁，铁素体</translation>
    </message>
    <message>
        <source>Malleable cast iron, pearlitic</source>
        <translation>可锻铸铁，珠光体</translation>
    </message>
    <message>
        <source>Wrought aluminium alloy</source>
        <translation>变形铝合金</translation>
    </message>
    <message>
        <source>Wrought aluminium alloy, cured</source>
        <translation>变形铝合金，时效</translation>
    </message>
    <message>
        <source>Cast aluminium alloy to 12 % Si</source>
        <translation>铸造铝合金，含硅量不超过 12 %</translation>
    </message>
    <message>
        <source>Cast aluminium alloy to 12 % Si, cured</source>
        <translation>铸造铝合金，含硅量不超过 12 %，时效</translation>
    </message>
    <message>
        <source>Cast aluminium alloy above 12 % Si</source>
        <translation>铸造铝合金，含硅量高于 12 %</translation>
    </message>
    <message>
        <source>Free-cutting copper alloy</source>
        <translation>易切削铜合金</translation>
    </message>
    <message>
        <source>Brass</source>
        <translation>黄铜</translation>
    </message>
    <message>
        <source>Electrolytic copper</source>
        <translation>电解铜</translation>
    </message>
    <message>
        <source>Heat-resistant alloy on iron base, annealed</source>
        <translation>铁基耐热合金，退火</translation>
    </message>
    <message>
        <source>Heat-resistant alloy on iron base, cured</source>
        <translation>铁基耐热合金，时效</translation>
    </message>
    <message>
        <source>Heat-resistant alloy on nickel or cobalt base</source>
        <translation>镍基或钴基耐热合金</translation>
    </message>
    <message>
        <source>Pure titanium</source>
        <translation>纯钛</translation>
    </message>
    <message>
        <source>Titanium alloy, alpha and beta</source>
        <translation>钛合金，α+β 型</translation>
    </message>
    <message>
        <source>Mild steel, 520 MPa</source>
        <translation>软钢，520 MPa</translation>
    </message>
    <message>
        <source>Medium steel, 620 MPa</source>
        <translation>中硬钢，620 MPa</translation>
    </message>
    <message>
        <source>Hard steel, 720 MPa</source>
        <translation>硬钢，720 MPa</translation>
    </message>
    <message>
        <source>Tool steel, 670 MPa</source>
        <translation>工具钢，670 MPa</translation>
    </message>
    <message>
        <source>Tool steel, 770 MPa</source>
        <translation>工具钢，770 MPa</translation>
    </message>
    <message>
        <source>Chrome-manganese steel, 770 MPa</source>
        <translation>铬锰钢，770 MPa</translation>
    </message>
    <message>
        <source>Chrome-manganese steel, 630 MPa</source>
        <translation>铬锰钢，630 MPa</translation>
    </message>
    <message>
        <source>Chrome-molybdenum steel, 730 MPa</source>
        <translation>铬钼钢，730 MPa</translation>
    </message>
    <message>
        <source>Chrome-molybdenum steel, 600 MPa</source>
        <translation>铬钼钢，600 MPa</translation>
    </message>
    <message>
        <source>Nickel-chrome-molybdenum steel, 900 MPa</source>
        <translation>镍铬钼钢，900 MPa</translation>
    </message>
    <message>
        <source>Nickel-chrome-molybdenum steel, 352 HB</source>
        <translation>镍铬钼钢，352 HB</translation>
    </message>
    <message>
        <source>Hard cast iron, 46 HRC</source>
        <translation>硬铸铁，46 HRC</translation>
    </message>
    <message>
        <source>Meehanite cast iron, 360 MPa</source>
        <translation>密烘铸铁，360 MPa</translation>
    </message>
    <message>
        <source>Grey cast iron, 200 HB</source>
        <translation>灰铸铁，200 HB</translation>
    </message>
    <message>
        <source>Its own</source>
        <translation>自身的</translation>
    </message>
    <message>
        <source>Process of the path</source>
        <translation>路径的加工参数</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Carve</source>
        <translation>挖去</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Attract</source>
        <translation>吸引</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>捏合</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Depth (mouse)</source>
        <translation>深度（鼠标）</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>衰减</translation>
    </message>
    <message>
        <source>Mirror across X</source>
        <translation>X 向镜像</translation>
    </message>
    <message>
        <source>Mirror across Y</source>
        <translation>Y 向镜像</translation>
    </message>
    <message>
        <source>Mirror across Z</source>
        <translation>Z 向镜像</translation>
    </message>
    <message>
        <source>Twist drill</source>
        <translation>麻花钻</translation>
    </message>
    <message>
        <source>Spindle (r/min)</source>
        <translation>主轴转速 (r/min)</translation>
    </message>
    <message>
        <source>Feed by the mouse (mm/s)</source>
        <translation>鼠标进给 (mm/s)</translation>
    </message>
    <message>
        <source>Thrust (N)</source>
        <translation>轴向力 (N)</translation>
    </message>
    <message>
        <source>Torque (N·mm)</source>
        <translation>扭矩 (N·mm)</translation>
    </message>
    <message>
        <source>Largest thrust (N)</source>
        <translation>最大轴向力 (N)</translation>
    </message>
    <message>
        <source>Largest torque (N·mm)</source>
        <translation>最大扭矩 (N·mm)</translation>
    </message>
    <message>
        <source>Removed (mm³)</source>
        <translation>去除量 (mm³)</translation>
    </message>
    <message>
        <source>Work (J)</source>
        <translation>功 (J)</translation>
    </message>
    <message>
        <source>Breakthrough after (s)</source>
        <translation>钻穿用时 (s)</translation>
    </message>
    <message>
        <source>Cycles a second</source>
        <translation>每秒周期数</translation>
    </message>
    <message>
        <source>Erosion</source>
        <translation>侵蚀</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>It was the outer boundary of an open sheet.</source>
        <translation>这曾是开放曲面的外边界。</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Largest parts</source>
        <translation>最大的部分</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Done when met</source>
        <translation>完成条件</translation>
    </message>
    <message>
        <source>Planned path</source>
        <translation>规划路径</translation>
    </message>
    <message>
        <source>Tolerance of the path</source>
        <translation>路径的公差</translation>
    </message>
    <message>
        <source>Entry (mm): x; y; z</source>
        <translation>入口 (mm)：x; y; z</translation>
    </message>
    <message>
        <source>Direction: x; y; z</source>
        <translation>方向：x; y; z</translation>
    </message>
    <message>
        <source>Forbidden balls (mm): x; y; z; radius, with | between</source>
        <translation>禁区球 (mm)：x; y; z; 半径，之间以 | 分隔</translation>
    </message>
    <message>
        <source>Drill: ball:6, burr:4 or twist:3</source>
        <translation>钻头：ball:6、burr:4 或 twist:3</translation>
    </message>
    <message>
        <source>the target is thicker than the bar</source>
        <translation>目标比棒料粗</translation>
    </message>
    <message>
        <source>the target is longer than the bar</source>
        <translation>目标比棒料长</translation>
    </message>
    <message>
        <source>the target goes beyond the chuck&apos;s end of the bar</source>
        <translation>目标超出棒料的卡盘端</translation>
    </message>
    <message>
        <source>the target goes beyond the free end of the bar</source>
        <translation>目标超出棒料的自由端</translation>
    </message>
    <message>
        <source>Left for facing at the free end</source>
        <translation>自由端的端面余量</translation>
    </message>
    <message>
        <source>Finished face, zero of the drawing and programs, Z</source>
        <translation>完工端面（图纸和程序的零点），Z</translation>
    </message>
    <message>
        <source>Left behind the part at the chuck&apos;s end</source>
        <translation>零件之后卡盘端的余料</translation>
    </message>
    <message>
        <source>Nose radius of the tool</source>
        <translation>刀具的刀尖圆弧半径</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>车削</translation>
    </message>
    <message>
        <source>The outside</source>
        <translation>外圆</translation>
    </message>
    <message>
        <source>A bore</source>
        <translation>内孔</translation>
    </message>
    <message>
        <source>The part takes the shape of</source>
        <translation>零件的形状取自</translation>
    </message>
    <message>
        <source>The nose, exactly</source>
        <translation>刀尖，精确</translation>
    </message>
    <message>
        <source>A smooth curve near it</source>
        <translation>与其接近的平滑曲线</translation>
    </message>
    <message>
        <source>Distance of the points of the curve</source>
        <translation>曲线点的间距</translation>
    </message>
    <message>
        <source>Robot to plan for</source>
        <translation>要规划的机器人</translation>
    </message>
    <message>
        <source>they cannot be scored without a limit</source>
        <translation>未设限值则无法评分</translation>
    </message>
    <message>
        <source>No points at all if not met</source>
        <translation>未达到此项则完全不得分</translation>
    </message>
    <message>
        <source>the place to measure is missing</source>
        <translation>缺少测量位置</translation>
    </message>
    <message>
        <source>The centres of the faces</source>
        <translation>两面的中心</translation>
    </message>
    <message>
        <source>Attracted within</source>
        <translation>吸附到路径的距离</translation>
    </message>
    <message>
        <source>Distance behind the hand</source>
        <translation>落后于手的距离</translation>
    </message>
    <message>
        <source>Opposite direction</source>
        <translation>反方向</translation>
    </message>
    <message>
        <source>Current position of the robot</source>
        <translation>机器人当前位置</translation>
    </message>
    <message>
        <source>Edge of a voxel</source>
        <translation>体素的边长</translation>
    </message>
    <message>
        <source>Close gaps up to a radius of</source>
        <translation>封闭间隙的最大半径</translation>
    </message>
    <message>
        <source>Memory for the voxels (MB)</source>
        <translation>体素所需内存 (MB)</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>抽壳</translation>
    </message>
    <message>
        <source>Move surface</source>
        <translation>偏移表面</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>组合</translation>
    </message>
    <message>
        <source>Remove debris</source>
        <translation>移除碎片</translation>
    </message>
    <message>
        <source>Close gaps</source>
        <translation>封闭间隙</translation>
    </message>
    <message>
        <source>Smooth all</source>
        <translation>全部平滑</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>With</source>
        <translation>组合对象</translation>
    </message>
    <message>
        <source>Parts that go</source>
        <translation>将移除的部件</translation>
    </message>
    <message>
        <source>Material then (mm³)</source>
        <translation>更改后的材料体积 (mm³)</translation>
    </message>
    <message>
        <source>Difference (mm³)</source>
        <translation>差值 (mm³)</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Unite</source>
        <translation>并集</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>差集</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>交集</translation>
    </message>
    <message>
        <source>Smaller than a ball of</source>
        <translation>小于直径为此值的球</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁的位置</translation>
    </message>
    <message>
        <source>All of the surface</source>
        <translation>表面的全部三角形</translation>
    </message>
    <message>
        <source>Within a distance</source>
        <translation>在一定距离内</translation>
    </message>
    <message>
        <source>So many</source>
        <translation>指定数量</translation>
    </message>
    <message>
        <source>Triangles of the mesh</source>
        <translation>网格的三角形数</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Marching cubes</source>
        <translation>移动立方体</translation>
    </message>
    <message>
        <source>Dual contouring</source>
        <translation>对偶轮廓</translation>
    </message>
    <message>
        <source>Inside the surface</source>
        <translation>表面内侧</translation>
    </message>
    <message>
        <source>Outside the surface</source>
        <translation>表面外侧</translation>
    </message>
    <message>
        <source>On both sides of it</source>
        <translation>表面两侧</translation>
    </message>
    <message>
        <source>Dome</source>
        <translation>圆顶</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>棱锥</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>Pebbles</source>
        <translation>卵石</translation>
    </message>
    <message>
        <source>Scales</source>
        <translation>鳞片</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>遮罩</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>印章</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Pressure changes</source>
        <translation>压力影响</translation>
    </message>
    <message>
        <source>Drag of a chip 1 mm wide (N·s/mm)</source>
        <translation>1 mm 宽切屑的阻力 (N·s/mm)</translation>
    </message>
    <message>
        <source>Surface area (mm²)</source>
        <translation>表面积 (mm²)</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>块</translation>
    </message>
    <message>
        <source>Places of paths</source>
        <translation>路径的位置</translation>
    </message>
    <message>
        <source>Place taken within</source>
        <translation>抓取位置的距离</translation>
    </message>
    <message>
        <source>More than a quarter of the memory</source>
        <translation>超过四分之一的内存</translation>
    </message>
    <message>
        <source>Smudge</source>
        <translation>涂抹</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Burr</source>
        <translation>旋转锉</translation>
    </message>
    <message>
        <source>Circular saw</source>
        <translation>圆锯</translation>
    </message>
    <message>
        <source>Peck by the mouse (0: none)</source>
        <translation>鼠标啄钻深度（0：无）</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Size of the voxels</source>
        <translation>体素大小</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Coordinates and programs</source>
        <translation>坐标和程序</translation>
    </message>
    <message>
        <source>In the frame</source>
        <translation>所在坐标系</translation>
    </message>
    <message>
        <source>what carried it was removed</source>
        <translation>其载体已被移除</translation>
    </message>
    <message>
        <source>Volume of all bodies added up (mm³)</source>
        <translation>所有实体体积之和 (mm³)</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Memory of the layers (MB)</source>
        <translation>图层占用内存 (MB)</translation>
    </message>
    <message>
        <source>Moves with the frame</source>
        <translation>随坐标系移动</translation>
    </message>
    <message>
        <source>Coordinates in</source>
        <translation>坐标所在</translation>
    </message>
    <message>
        <source>the cell</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>Clearance to keep</source>
        <translation>须保持的间隙</translation>
    </message>
    <message>
        <source>Programs allowed</source>
        <translation>允许使用程序</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>节拍时间</translation>
    </message>
    <message>
        <source>Security index</source>
        <translation>安全指数</translation>
    </message>
    <message>
        <source>Manipulability</source>
        <translation>可操作度</translation>
    </message>
    <message>
        <source>Depth of the hole</source>
        <translation>孔深</translation>
    </message>
    <message>
        <source>End, at Z</source>
        <translation>端部，Z 处</translation>
    </message>
    <message>
        <source>Volume that stays in the chuck (mm³)</source>
        <translation>留在卡盘中的体积 (mm³)</translation>
    </message>
    <message>
        <source>Volume parted off (mm³)</source>
        <translation>切下的体积 (mm³)</translation>
    </message>
    <message>
        <source>Length parted off (mm)</source>
        <translation>切下的长度 (mm)</translation>
    </message>
    <message>
        <source>Compound slide angle, ° (+: thicker away from the chuck)</source>
        <translation>小刀架角度，°（+：远离卡盘处变粗）</translation>
    </message>
    <message>
        <source>Failed tries that were undone</source>
        <translation>已撤销的失败尝试</translation>
    </message>
    <message>
        <source>cost the mark of the forbidden region</source>
        <translation>扣除禁区一项的分数</translation>
    </message>
    <message>
        <source>fail the work</source>
        <translation>使整份作业不合格</translation>
    </message>
    <message>
        <source>are listed only</source>
        <translation>仅列出</translation>
    </message>
    <message>
        <source>it turns to and fro again and again: a section, or a larger tolerance, is smoother</source>
        <translation>它反复来回转折：截面或更大的公差会更平滑</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>尝试次数</translation>
    </message>
    <message>
        <source>Commands that cut, such as Thread, allowed</source>
        <translation>允许切削命令，例如“螺纹”</translation>
    </message>
    <message>
        <source>Largest resultant force (N)</source>
        <translation>最大切削合力 (N)</translation>
    </message>
    <message>
        <source>no known material: forces are those of a medium carbon steel</source>
        <translation>未知材料：切削力按中碳钢计算</translation>
    </message>
    <message>
        <source>the limits contradict the class of the thread there: they admit sizes that it refuses</source>
        <translation>极限与该处螺纹的公差带相矛盾：允许了公差带不接受的尺寸</translation>
    </message>
    <message>
        <source>Shapes that could not be read</source>
        <translation>无法读取的形状</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺少</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>略去</translation>
    </message>
    <message>
        <source>nothing is proven free until it is left out or replaced</source>
        <translation>在略去或代替它之前，无法证明任何路径无碰撞</translation>
    </message>
    <message>
        <source>Duration (s), 0: by the speed</source>
        <translation>时长（秒），0：按速度</translation>
    </message>
    <message>
        <source>Rounding (CNT, %)</source>
        <translation>圆滑过渡（CNT，%）</translation>
    </message>
    <message>
        <source>Carries the same after its lines</source>
        <translation>执行其语句后携带的物体不变</translation>
    </message>
    <message>
        <source>Speed of joints without one (per second)</source>
        <translation>未给出速度的关节的速度（每秒）</translation>
    </message>
    <message>
        <source>Speed of slides without one (per second)</source>
        <translation>未给出速度的滑动轴的速度（每秒）</translation>
    </message>
    <message>
        <source>From rest to full speed (s)</source>
        <translation>从静止到全速（秒）</translation>
    </message>
    <message>
        <source>From rest to full acceleration (s)</source>
        <translation>从静止到最大加速度（秒）</translation>
    </message>
    <message>
        <source>Assumed for the times of paths</source>
        <translation>路径时间的假设值</translation>
    </message>
    <message>
        <source>At a device</source>
        <translation>在设备上</translation>
    </message>
    <message>
        <source>Near below</source>
        <translation>近距离阈值</translation>
    </message>
    <message>
        <source>the surface lies in the plane</source>
        <translation>曲面位于该平面内</translation>
    </message>
    <message>
        <source>Time for the repair, about (s)</source>
        <translation>修复所需时间，约 (s)</translation>
    </message>
    <message>
        <source>Its triangles touch without a common edge, or more than two share one.</source>
        <translation>其三角形相接触但没有公共边，或两个以上三角形共用一条边。</translation>
    </message>
    <message>
        <source>It is as fine as its surroundings, and even.</source>
        <translation>它与周围一样精细且均匀。</translation>
    </message>
</context>
<context>
    <name>RepairSummary</name>
    <message numerus="yes">
        <source>%Ln hole(s)</source>
        <translation>
            <numerusform>%Ln 个孔洞</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln non-manifold edge(s)</source>
        <translation>
            <numerusform>%Ln 条非流形边</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln non-manifold vertex(ices)</source>
        <translation>
            <numerusform>%Ln 个非流形顶点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln one-sided edge(s)</source>
        <translation>
            <numerusform>%Ln 条单侧面的边</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln body(ies) inside out</source>
        <translation>
            <numerusform>%Ln 个内外翻转的物体</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of near vertices</source>
        <translation>
            <numerusform>%Ln 对邻近顶点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln degenerate triangle(s)</source>
        <translation>
            <numerusform>%Ln 个退化三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln duplicate triangle(s)</source>
        <translation>
            <numerusform>%Ln 个重复三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln self-intersection(s)</source>
        <translation>
            <numerusform>%Ln 处自相交</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln piece(s) of debris</source>
        <translation>
            <numerusform>%Ln 块碎片</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln reversed triangle(s)</source>
        <translation>
            <numerusform>%Ln 个反转的三角形</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 corrected</source>
        <translation>已纠正 %1（共 %2）</translation>
    </message>
    <message>
        <source>%1 of %2 removed</source>
        <translation>已移除 %1（共 %2）</translation>
    </message>
    <message>
        <source>new: %1</source>
        <translation>新增：%1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln outer boundary(ies) and kept hole(s)</source>
        <translation>
            <numerusform>%Ln 个外边界和保持开放的孔洞</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln inconsistent triangle(s)</source>
        <translation>
            <numerusform>%Ln 个方向不一致的三角形</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RepairText</name>
    <message>
        <source>Fair</source>
        <translation>光顺</translation>
    </message>
    <message>
        <source>Refined</source>
        <translation>细化</translation>
    </message>
    <message>
        <source>Stitched</source>
        <translation>缝合</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>it has more edges than allowed</source>
        <translation>边数超过允许值</translation>
    </message>
    <message>
        <source>colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>normals</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>texture coordinates</source>
        <translation>纹理坐标</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>分组</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>线段</translation>
    </message>
    <message>
        <source>curves</source>
        <translation>曲线</translation>
    </message>
    <message numerus="yes">
        <source>%n duplicate triangle(s) removed</source>
        <translation>
            <numerusform>移除 %n 个重复三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) of debris removed</source>
        <translation>
            <numerusform>移除碎片中的 %n 个三角形</numerusform>
        </translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>棱线</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>锥</translation>
    </message>
    <message>
        <source>exact surfaces</source>
        <translation>精确曲面</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>封闭</translation>
    </message>
    <message>
        <source>not closed</source>
        <translation>未封闭</translation>
    </message>
    <message>
        <source>manifold</source>
        <translation>流形</translation>
    </message>
    <message>
        <source>not manifold</source>
        <translation>非流形</translation>
    </message>
    <message>
        <source>oriented</source>
        <translation>方向一致</translation>
    </message>
    <message>
        <source>not oriented</source>
        <translation>方向不一致</translation>
    </message>
    <message>
        <source>free of self-intersections</source>
        <translation>无自相交</translation>
    </message>
    <message numerus="yes">
        <source>%n self-intersection(s)</source>
        <translation>
            <numerusform>%n 处自相交</numerusform>
        </translation>
    </message>
    <message>
        <source>one piece</source>
        <translation>一个整体</translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s)</source>
        <translation>
            <numerusform>%n 块</numerusform>
        </translation>
    </message>
    <message>
        <source>Ear clipping</source>
        <translation>耳切法</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Thickened sheet</source>
        <translation>加厚曲面</translation>
    </message>
    <message>
        <source>Area and bending</source>
        <translation>面积与弯折</translation>
    </message>
    <message>
        <source>Minimum area</source>
        <translation>最小面积</translation>
    </message>
    <message>
        <source>Minimum bending</source>
        <translation>最小弯折</translation>
    </message>
    <message>
        <source>Triangles as fine as the surroundings, curved to continue them. For scans.</source>
        <translation>三角形与周围一样细密，并顺着周围弯曲。适合扫描数据。</translation>
    </message>
    <message>
        <source>Triangles as fine as the surroundings, not curved. For flat regions.</source>
        <translation>三角形与周围一样细密，不弯曲。适合平坦处。</translation>
    </message>
    <message>
        <source>Cuts off one corner after the other, the best first; adds no vertices. For holes with many edges.</source>
        <translation>逐个切去角，最优者先切；不添加顶点。适用于边数很多的孔洞。</translation>
    </message>
    <message>
        <source>Small angles between adjacent triangles, then a small area, using edges of the Delaunay tetrahedralisation; adds no vertices.</source>
        <translation>使用 Delaunay 四面体剖分的边，先使相邻三角形夹角小，再使面积小；不添加顶点。</translation>
    </message>
    <message>
        <source>Minimises the area; adds no vertices. A hole of more than 300 edges is divided first.</source>
        <translation>面积最小；不添加顶点。超过 300 条边的孔洞会先被分割。</translation>
    </message>
    <message>
        <source>Minimises the angles between adjacent triangles, then the area; adds no vertices. A hole of more than 300 edges is divided first.</source>
        <translation>先使相邻三角形的夹角最小，再使面积最小；不添加顶点。超过 300 条边的孔洞会先被分割。</translation>
    </message>
    <message>
        <source>As fair, with the sharp edges that end at the hole continued across it. For designed parts.</source>
        <translation>与光顺相同,但终止于孔边的锐边会贯穿补片。适用于设计零件。</translation>
    </message>
    <message>
        <source>A planar patch in the best-fitting plane of the boundary; adds no vertices. For openings that were cut.</source>
        <translation>位于边界最佳拟合平面内的平面补片；不添加顶点。适用于切割出的开口。</translation>
    </message>
    <message>
        <source>Triangles to one apex behind or in front of the hole.</source>
        <translation>连向孔后或孔前一点的三角形。</translation>
    </message>
    <message>
        <source>The sheet was thickened to a thin body.</source>
        <translation>曲面已加厚为薄体。</translation>
    </message>
    <message>
        <source>The boundaries were joined.</source>
        <translation>边界已接合。</translation>
    </message>
    <message>
        <source>The triangles around it were removed.</source>
        <translation>其周围的三角形已移除。</translation>
    </message>
    <message>
        <source>it is the outer boundary of an open sheet</source>
        <translation>这是开放曲面的外边界</translation>
    </message>
    <message>
        <source>it is marked to be kept open</source>
        <translation>已标记为保持开放</translation>
    </message>
    <message>
        <source>no valid patch fits its boundary</source>
        <translation>没有有效的补片能贴合其边界</translation>
    </message>
    <message>
        <source>every patch would intersect the part</source>
        <translation>任何补片都会与零件相交</translation>
    </message>
    <message>
        <source>every patch would bulge out too far</source>
        <translation>任何补片都会明显鼓出</translation>
    </message>
    <message>
        <source>no patch fits, perhaps due to narrow triangles along its boundary; “Repair all” removes them</source>
        <translation>没有补片能贴合，可能因为其边界上有狭窄的三角形；“全部修复”会移除它们</translation>
    </message>
    <message>
        <source>isolated points</source>
        <translation>孤立点</translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) reversed</source>
        <translation>
            <numerusform>反转了 %n 个三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n degenerate triangle(s) removed</source>
        <translation>
            <numerusform>移除了 %n 个退化三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n dangling triangle(s) removed</source>
        <translation>
            <numerusform>移除 %n 个悬挂三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n near vertex(ices) merged</source>
        <translation>
            <numerusform>合并了 %n 个邻近顶点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) cut where patches intersect</source>
        <translation>
            <numerusform>在补片相交处切开了 %n 个三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>self-intersections resolved at %n place(s)</source>
        <translation>
            <numerusform>在 %n 处消除了自相交</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s) to be kept open lost with removed triangles</source>
        <translation>
            <numerusform>%n 个应保持开放的孔洞随被删除的三角形消失</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n folded triangle(s) replaced around holes</source>
        <translation>
            <numerusform>替换了孔洞周围 %n 个折叠的三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cut(s) where the surface was one-sided</source>
        <translation>
            <numerusform>在仅有一侧的表面上切开 %n 处</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n touching vertex(ices) separated</source>
        <translation>
            <numerusform>分开了 %n 个相接的顶点</numerusform>
        </translation>
    </message>
    <message>
        <source>the patch bends by %1°, its surroundings by at most %2°</source>
        <translation>补片弯折 %1°，周围最多 %2°</translation>
    </message>
    <message>
        <source>the patch bulges by %1 % of the size of the hole beyond its surroundings</source>
        <translation>补片超出周围隆起，达孔洞尺寸的 %1 %</translation>
    </message>
    <message>
        <source>further data</source>
        <translation>其他数据</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message numerus="yes">
        <source>%n body(ies) inside out reversed</source>
        <translation>
            <numerusform>已反转 %n 个内外颠倒的体</numerusform>
        </translation>
    </message>
    <message>
        <source>sheets thickened by %1</source>
        <translation>片体加厚 %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>however thin, the body of the sheet would intersect the part</source>
        <translation>无论多薄，片体的实体都会与零件相交</translation>
    </message>
    <message>
        <source>the numbers of the file cannot show such a thickness</source>
        <translation>文件的数值无法表示这样的厚度</translation>
    </message>
    <message>
        <source>a boundary of the sheet is marked to stay open, and a thin body has none</source>
        <translation>片体有一条边界标记为保持开放，而薄实体没有边界</translation>
    </message>
    <message>
        <source>sheets: %1</source>
        <translation>片体：%1</translation>
    </message>
    <message>
        <source>none of %1 thickened</source>
        <translation>%1 个均未加厚</translation>
    </message>
    <message>
        <source>%1 of %2 thickened by %3</source>
        <translation>%2 个中的 %1 个已加厚 %3</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) left open: %1</source>
        <translation>
            <numerusform>%n 个片体保持开放：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Outer boundary %1</source>
        <translation>外边界 %1</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <translation>孔 %1</translation>
    </message>
    <message numerus="yes">
        <source>%1, thinner than requested at %2 of %n vertex(ices)</source>
        <translation>
            <numerusform>%1，%n 个顶点中有 %2 个比要求的薄</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n hole(s) filled</source>
        <translation>
            <numerusform>已填补 %1 个孔洞（共 %n 个）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n kept open</source>
        <translation>
            <numerusform>%n 个保持开放</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n could not be filled</source>
        <translation>
            <numerusform>%n 个无法填补</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>split or joined, %n hole(s) are left</source>
        <translation>
            <numerusform>经拆分或合并，剩余 %n 个孔洞</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new opening(s)</source>
        <translation>
            <numerusform>%n 个新开口</numerusform>
        </translation>
    </message>
    <message>
        <source>the effort that a mesh of this size allows was used up</source>
        <translation>此大小的网格所允许的计算量已用完</translation>
    </message>
    <message>
        <source>it was the outer boundary of an open sheet, which has been changed so that it looks like a hole now</source>
        <translation>这曾是开放曲面的外边界，更改后现在看起来像孔洞</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n outer boundary(ies) closed</source>
        <translation>
            <numerusform>已封闭 %1 个外边界（共 %n 个）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n removed together with other triangles</source>
        <translation>
            <numerusform>%n 个随其他三角形一起移除</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n now part of the boundary of an open sheet</source>
        <translation>
            <numerusform>%n 个现为开放片体边界的一部分</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n outer boundary(ies) removed together with other triangles</source>
        <translation>
            <numerusform>%n 个外边界随其他三角形一起移除</numerusform>
        </translation>
    </message>
    <message>
        <source>bodies that intersect united</source>
        <translation>已合并相交的实体</translation>
    </message>
    <message>
        <source>A part of the surface that stood out by %1 was removed, at X %2, Y %3, Z %4.</source>
        <translation>已移除表面上突出 %1 的部分，位于 X %2、Y %3、Z %4。</translation>
    </message>
    <message>
        <source>The patch spans the hole without continuing the slopes around it; continuing them, it would bulge out or intersect the part.</source>
        <translation>补片跨越孔洞，未延续周围的坡度；若延续，它会鼓出或与零件相交。</translation>
    </message>
    <message>
        <source>The patch is by “%1”; the chosen method finds no valid patch.</source>
        <translation>补片由“%1”生成；所选方法找不到有效补片。</translation>
    </message>
    <message numerus="yes">
        <source>%n patch(es) not continuing the slopes around</source>
        <translation>
            <numerusform>%n 个补片未延续周围的坡度</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patch(es) by another method than the chosen one</source>
        <translation>
            <numerusform>%n 个补片未使用所选方法</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) of second layers removed</source>
        <translation>
            <numerusform>已移除 %n 个重叠层三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>cracks stitched by moving %n vertex(ices)</source>
        <translation>
            <numerusform>移动 %n 个顶点以缝合裂缝</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>noise smoothed at %n folded vertex(ices)</source>
        <translation>
            <numerusform>已在 %n 个折叠顶点处平滑噪声</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SubmissionTable</name>
    <message>
        <source>Student</source>
        <translation>学生</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Handed in</source>
        <translation>提交时间</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>分钟</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>Percent</source>
        <translation>百分比</translation>
    </message>
    <message>
        <source>points</source>
        <translation>分</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>by program</source>
        <translation>由程序</translation>
    </message>
    <message>
        <source>both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>加工方式</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>尝试次数</translation>
    </message>
    <message>
        <source>by command</source>
        <translation>用命令</translation>
    </message>
    <message>
        <source>by hand and command</source>
        <translation>手动和用命令</translation>
    </message>
    <message>
        <source>by program and command</source>
        <translation>用程序和命令</translation>
    </message>
    <message>
        <source>by hand, program and command</source>
        <translation>手动、用程序和用命令</translation>
    </message>
</context>
<context>
    <name>Suggestions</name>
    <message numerus="yes">
        <source>%Ln hole(s) found.</source>
        <translation>
            <numerusform>发现 %Ln 个孔洞。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 stays open: %2.</source>
        <translation>%1 未填补：%2。</translation>
    </message>
    <message numerus="yes">
        <source>…and %Ln more, see the list.</source>
        <translation>
            <numerusform>…还有 %Ln 个，见列表。</numerusform>
        </translation>
    </message>
    <message>
        <source>No holes. This is an open sheet.</source>
        <translation>没有孔洞。这是一张开放曲面。</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>已保存为 %1。</translation>
    </message>
    <message>
        <source>There is nothing to repair.</source>
        <translation>没有需要修复的内容。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln hole(s) could not be filled.</source>
        <translation>
            <numerusform>%Ln 个孔洞无法填补。</numerusform>
        </translation>
    </message>
    <message>
        <source>No holes remain except those kept open.</source>
        <translation>除保持开放的以外，已无孔洞。</translation>
    </message>
    <message>
        <source>Some defects remain.</source>
        <translation>仍有一些缺陷。</translation>
    </message>
    <message>
        <source>No holes.</source>
        <translation>没有孔。</translation>
    </message>
    <message numerus="yes">
        <source>No holes. These are %Ln open sheet(s).</source>
        <translation>
            <numerusform>没有孔。这是 %Ln 个开放片体。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No holes. %Ln open sheet(s) among %1 pieces.</source>
        <translation>
            <numerusform>没有孔。%1 个部分中有 %Ln 个开放片体。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln open sheet(s).</source>
        <translation>
            <numerusform>%Ln 个开放片体。</numerusform>
        </translation>
    </message>
    <message>
        <source>The self-intersections stay: %1.</source>
        <translation>自相交仍然存在：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s) reversed on opening.</source>
        <translation>
            <numerusform>打开时翻转了 %Ln 个三角形。</numerusform>
        </translation>
    </message>
    <message>
        <source>Closed. Looking for self-intersections…</source>
        <translation>封闭。正在查找自相交…</translation>
    </message>
    <message numerus="yes">
        <source>…and %Ln more, see the log.</source>
        <translation>
            <numerusform>…还有 %Ln 个，见日志。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln hole(s) left.</source>
        <translation>
            <numerusform>还剩 %Ln 个孔洞。</numerusform>
        </translation>
    </message>
    <message>
        <source>Outer boundaries of open sheets that the repair changed and that look like holes now: %1. Another repair tries to fill them.</source>
        <translation>修复改动过、现在看起来像孔洞的开放片外边界：%1 个。再次修复会尝试填补它们。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln body(ies) inside another: “Unite bodies” removes what lies inside.</source>
        <translation>
            <numerusform>%Ln 个体位于另一个体内：“合并实体”会移除内部部分。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TimingPlot</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>节拍数</translation>
    </message>
</context>
<context>
    <name>Tool</name>
    <message>
        <source>second point</source>
        <translation>第二点</translation>
    </message>
    <message>
        <source>first point</source>
        <translation>第一点</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>start again</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>choose a hole</source>
        <translation>选择孔洞</translation>
    </message>
    <message>
        <source>fill the hole</source>
        <translation>填补孔洞</translation>
    </message>
    <message>
        <source>next hole</source>
        <translation>下一个孔洞</translation>
    </message>
    <message>
        <source>previous hole</source>
        <translation>上一个孔洞</translation>
    </message>
    <message>
        <source>no longer keep open</source>
        <translation>不再保持开放</translation>
    </message>
    <message>
        <source>keep open</source>
        <translation>保持开放</translation>
    </message>
    <message>
        <source>Selecting by lasso</source>
        <translation>正在用套索选择</translation>
    </message>
    <message>
        <source>select a face or a hole</source>
        <translation>选择面或孔洞</translation>
    </message>
    <message>
        <source>paint faces</source>
        <translation>涂选面</translation>
    </message>
    <message>
        <source>draw a line around faces</source>
        <translation>围绕面画线</translation>
    </message>
    <message>
        <source>Delete faces</source>
        <translation>删除面</translation>
    </message>
    <message>
        <source>add to the selection</source>
        <translation>添加到选择</translation>
    </message>
    <message>
        <source>smaller brush</source>
        <translation>缩小画笔</translation>
    </message>
    <message>
        <source>larger brush</source>
        <translation>放大画笔</translation>
    </message>
    <message>
        <source>select all</source>
        <translation>全选</translation>
    </message>
    <message>
        <source>grow by one ring</source>
        <translation>扩展一圈</translation>
    </message>
    <message>
        <source>shrink by one ring</source>
        <translation>收缩一圈</translation>
    </message>
    <message>
        <source>previous selection</source>
        <translation>上一个选择</translation>
    </message>
    <message>
        <source>next selection</source>
        <translation>下一个选择</translation>
    </message>
    <message>
        <source>delete the faces</source>
        <translation>删除面</translation>
    </message>
    <message>
        <source>move the joint</source>
        <translation>移动关节</translation>
    </message>
    <message>
        <source>pull the whole arm</source>
        <translation>拖动整个机械臂</translation>
    </message>
    <message>
        <source>Remove debris</source>
        <translation>移除碎片</translation>
    </message>
    <message>
        <source>third point</source>
        <translation>第三点</translation>
    </message>
    <message>
        <source>first face</source>
        <translation>第一个面</translation>
    </message>
    <message>
        <source>second face</source>
        <translation>第二个面</translation>
    </message>
    <message>
        <source>bridge instead of joining</source>
        <translation>搭桥而不连接</translation>
    </message>
    <message>
        <source>find islands</source>
        <translation>查找孤岛</translation>
    </message>
    <message>
        <source>find peninsulas</source>
        <translation>查找半岛</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>移除孤岛</translation>
    </message>
    <message>
        <source>Remove peninsulas</source>
        <translation>移除半岛</translation>
    </message>
    <message>
        <source>Remove duplicate triangles</source>
        <translation>移除重复三角形</translation>
    </message>
    <message>
        <source>Merge near vertices</source>
        <translation>合并邻近顶点</translation>
    </message>
    <message>
        <source>it would take too long for a mesh of this size</source>
        <translation>对于这样大小的网格，这会花费太长时间</translation>
    </message>
    <message>
        <source>Cut and close</source>
        <translation>切开并封闭</translation>
    </message>
    <message>
        <source>choose the bridges again</source>
        <translation>重新自动选择桥接</translation>
    </message>
    <message>
        <source>Make a face</source>
        <translation>创建面</translation>
    </message>
    <message>
        <source>first corner, on an open edge</source>
        <translation>第一个角点，位于开放边上</translation>
    </message>
    <message>
        <source>second corner, counter-clockwise</source>
        <translation>第二个角点，逆时针方向</translation>
    </message>
    <message>
        <source>Smooth surface</source>
        <translation>平滑表面</translation>
    </message>
    <message>
        <source>Inflate surface</source>
        <translation>膨胀表面</translation>
    </message>
    <message>
        <source>Flatten surface</source>
        <translation>压平表面</translation>
    </message>
    <message>
        <source>Drag surface</source>
        <translation>拖动表面</translation>
    </message>
    <message>
        <source>Subdivide patch</source>
        <translation>细分补片</translation>
    </message>
    <message>
        <source>Refine to the surroundings</source>
        <translation>细化到与周围一致</translation>
    </message>
    <message>
        <source>Subdividing</source>
        <translation>正在细分</translation>
    </message>
    <message>
        <source>Smoothing noise</source>
        <translation>正在平滑噪声</translation>
    </message>
    <message>
        <source>Smooth noise</source>
        <translation>平滑噪声</translation>
    </message>
    <message>
        <source>One level back</source>
        <translation>退回一级</translation>
    </message>
    <message>
        <source>sculpt</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>subdivide the patch</source>
        <translation>细分补片</translation>
    </message>
    <message>
        <source>one level back</source>
        <translation>退回一级</translation>
    </message>
    <message>
        <source>refine to the surroundings</source>
        <translation>细化到与周围一致</translation>
    </message>
    <message>
        <source>sculpt a coarser level</source>
        <translation>雕刻较粗的层级</translation>
    </message>
    <message>
        <source>sculpt a finer level</source>
        <translation>雕刻较细的层级</translation>
    </message>
    <message>
        <source>smooth the noise of the patch</source>
        <translation>平滑补片的噪声</translation>
    </message>
    <message>
        <source>smooth the noise along the holes</source>
        <translation>平滑孔洞周围的噪声</translation>
    </message>
    <message>
        <source>sculpt the whole surface</source>
        <translation>雕刻整个表面</translation>
    </message>
    <message>
        <source>centre on the origin</source>
        <translation>居中到原点</translation>
    </message>
    <message>
        <source>Centre on the origin</source>
        <translation>居中到原点</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>放置</translation>
    </message>
    <message>
        <source>coordinates would become too large</source>
        <translation>坐标会过大</translation>
    </message>
    <message>
        <source>reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Add a mesh</source>
        <translation>添加网格</translation>
    </message>
    <message>
        <source>join instead of bridging</source>
        <translation>合并而不架桥</translation>
    </message>
    <message>
        <source>Fill hole</source>
        <translation>填补孔洞</translation>
    </message>
    <message>
        <source>Change the unit</source>
        <translation>更改单位</translation>
    </message>
    <message>
        <source>Repair all</source>
        <translation>全部修复</translation>
    </message>
    <message>
        <source>Sculpt</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>cut a pass</source>
        <translation>走一刀</translation>
    </message>
    <message>
        <source>remove the body</source>
        <translation>移除物体</translation>
    </message>
    <message>
        <source>select a body</source>
        <translation>选择物体</translation>
    </message>
    <message>
        <source>Change bodies</source>
        <translation>更改物体</translation>
    </message>
    <message>
        <source>move the joint or the body</source>
        <translation>移动关节或物体</translation>
    </message>
    <message>
        <source>pull the whole arm, or move the body up and down</source>
        <translation>拖动整个手臂，或上下移动物体</translation>
    </message>
    <message>
        <source>move the body without snapping</source>
        <translation>移动物体（不吸附）</translation>
    </message>
    <message>
        <source>deselect the body</source>
        <translation>取消选择物体</translation>
    </message>
    <message>
        <source>the mesh has no more triangles than that</source>
        <translation>网格的三角形不比这更多</translation>
    </message>
    <message>
        <source>a job that changes this mesh is running</source>
        <translation>正在运行更改此网格的任务</translation>
    </message>
    <message>
        <source>no piece is far smaller than the largest</source>
        <translation>没有比最大块小很多的碎块</translation>
    </message>
    <message>
        <source>move the body</source>
        <translation>移动物体</translation>
    </message>
    <message>
        <source>move the body up and down</source>
        <translation>上下移动物体</translation>
    </message>
    <message>
        <source>Thicken sheets</source>
        <translation>加厚曲面</translation>
    </message>
    <message>
        <source>Separate touching parts</source>
        <translation>分开相接的部分</translation>
    </message>
    <message>
        <source>Make two-sided</source>
        <translation>变为双侧</translation>
    </message>
    <message>
        <source>Reverse faces</source>
        <translation>反转面</translation>
    </message>
    <message>
        <source>Resolve self-intersections</source>
        <translation>消除自相交</translation>
    </message>
    <message>
        <source>cancel the move</source>
        <translation>取消移动</translation>
    </message>
    <message>
        <source>keep this measurement</source>
        <translation>保留此测量</translation>
    </message>
    <message>
        <source>the boundary has changed meanwhile</source>
        <translation>边界在此期间已更改</translation>
    </message>
    <message>
        <source>not possible: two of the vertices are the same</source>
        <translation>无法执行：其中两个顶点相同</translation>
    </message>
    <message>
        <source>not possible: a triangle would flip or become degenerate</source>
        <translation>无法执行：会有三角形翻转或退化</translation>
    </message>
    <message>
        <source>not possible: an edge would have more than two triangles</source>
        <translation>无法执行：会有边超过两个三角形</translation>
    </message>
    <message>
        <source>not possible: the adjacent triangle has the opposite orientation</source>
        <translation>无法执行：相邻三角形的方向相反</translation>
    </message>
    <message>
        <source>not possible: it would touch the surface at a single vertex only</source>
        <translation>无法执行：它与曲面只会在一个顶点处相接</translation>
    </message>
    <message>
        <source>not possible: it would intersect or touch the part</source>
        <translation>无法执行：它会与零件相交或接触</translation>
    </message>
    <message>
        <source>not possible: there is no open edge</source>
        <translation>无法执行：没有开放边</translation>
    </message>
    <message>
        <source>smooth the boundary</source>
        <translation>平滑边界</translation>
    </message>
    <message>
        <source>deselect the hole</source>
        <translation>取消选择孔洞</translation>
    </message>
    <message>
        <source>move the vertex</source>
        <translation>移动顶点</translation>
    </message>
    <message>
        <source>move the vertex as far as possible</source>
        <translation>将顶点移动到允许的最远处</translation>
    </message>
    <message>
        <source>join the vertices</source>
        <translation>连接顶点</translation>
    </message>
    <message>
        <source>not possible: no other vertex is near</source>
        <translation>无法执行：附近没有其他顶点</translation>
    </message>
    <message>
        <source>add the bridge</source>
        <translation>添加桥接</translation>
    </message>
    <message>
        <source>drag a vertex; onto another one: join them</source>
        <translation>拖动顶点；拖到另一顶点上则连接</translation>
    </message>
    <message>
        <source>add a bridge to another vertex</source>
        <translation>添加到另一顶点的桥接</translation>
    </message>
    <message>
        <source>do not snap</source>
        <translation>不吸附</translation>
    </message>
    <message>
        <source>apply the smoothed boundary</source>
        <translation>应用平滑后的边界</translation>
    </message>
    <message>
        <source>remove the marked triangles</source>
        <translation>移除已标记的三角形</translation>
    </message>
    <message>
        <source>leave it unchanged</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>choose a boundary</source>
        <translation>选择边界</translation>
    </message>
    <message>
        <source>Analysing the boundary</source>
        <translation>正在分析边界</translation>
    </message>
    <message>
        <source>reduce triangles</source>
        <translation>减少三角形</translation>
    </message>
    <message>
        <source>they are the two sides of a plate of zero thickness, which is closed</source>
        <translation>它们是零厚度板的两面，该板已封闭</translation>
    </message>
    <message>
        <source>every separation would make the surface intersect itself</source>
        <translation>任何分离都会使曲面自相交</translation>
    </message>
    <message>
        <source>the cut could not be closed without intersecting the part</source>
        <translation>无法在不与零件相交的情况下封闭切口</translation>
    </message>
    <message>
        <source>the region to be cut is folded too much</source>
        <translation>要切割的区域折叠过多</translation>
    </message>
    <message>
        <source>bridge the hole from vertex to vertex</source>
        <translation>在两个顶点之间桥接孔洞</translation>
    </message>
    <message>
        <source>undo the last corner</source>
        <translation>撤销上一个角点</translation>
    </message>
    <message>
        <source>no triangle can be removed within the given limits</source>
        <translation>在给定限制内没有可移除的三角形</translation>
    </message>
    <message>
        <source>Reduce triangles</source>
        <translation>减少三角形</translation>
    </message>
    <message>
        <source>Add a bridge</source>
        <translation>添加桥接</translation>
    </message>
    <message>
        <source>Join boundary vertices</source>
        <translation>连接边界顶点</translation>
    </message>
    <message>
        <source>Move a boundary vertex</source>
        <translation>移动边界顶点</translation>
    </message>
    <message>
        <source>Smooth the boundary</source>
        <translation>平滑边界</translation>
    </message>
    <message>
        <source>Remove degenerate triangles</source>
        <translation>移除退化三角形</translation>
    </message>
    <message>
        <source>place on the largest flat face</source>
        <translation>放到最大的平面上</translation>
    </message>
    <message>
        <source>Place on the largest flat face</source>
        <translation>放到最大的平面上</translation>
    </message>
    <message>
        <source>align the principal axes</source>
        <translation>对齐主轴</translation>
    </message>
    <message>
        <source>Align the principal axes</source>
        <translation>对齐主轴</translation>
    </message>
    <message>
        <source>move the minimum corner to the origin</source>
        <translation>将最小角点移到原点</translation>
    </message>
    <message>
        <source>Move the minimum corner to the origin</source>
        <translation>将最小角点移到原点</translation>
    </message>
    <message>
        <source>opposite direction</source>
        <translation>相反方向</translation>
    </message>
    <message>
        <source>undo: the surface now intersects itself</source>
        <translation>撤销：表面现已自相交</translation>
    </message>
    <message>
        <source>invert the selection</source>
        <translation>反转选择</translation>
    </message>
    <message>
        <source>reverse the shells of the selected faces</source>
        <translation>反转所选面所在的壳体</translation>
    </message>
    <message>
        <source>clear the selection</source>
        <translation>清除选择</translation>
    </message>
    <message>
        <source>select connected faces</source>
        <translation>选择相连的面</translation>
    </message>
    <message>
        <source>select up to the next sharp edge</source>
        <translation>选择到下一条锐边</translation>
    </message>
    <message>
        <source>Selecting up to the next sharp edge</source>
        <translation>正在选择到下一条锐边</translation>
    </message>
    <message>
        <source>Selecting connected faces</source>
        <translation>正在选择相连的面</translation>
    </message>
    <message>
        <source>remove from the selection</source>
        <translation>从选择中移除</translation>
    </message>
    <message>
        <source>apply the placement</source>
        <translation>应用放置</translation>
    </message>
    <message>
        <source>discard the pass</source>
        <translation>放弃此次走刀</translation>
    </message>
    <message>
        <source>the pass is full: release it</source>
        <translation>走刀已满：请松开</translation>
    </message>
    <message>
        <source>third corner: creates the face</source>
        <translation>第三个角点：创建面</translation>
    </message>
    <message>
        <source>a boundary of the sheet is marked to stay open, and a thin body has none</source>
        <translation>片体有一条边界被标记为保持开放，而薄体没有边界</translation>
    </message>
    <message>
        <source>no cut would separate the triangles cleanly</source>
        <translation>没有切割能将这些三角形干净地分开</translation>
    </message>
    <message>
        <source>no body is inside out</source>
        <translation>没有内外颠倒的体</translation>
    </message>
    <message>
        <source>however thin, the body would intersect the part</source>
        <translation>无论多薄，该体都会与部件相交</translation>
    </message>
    <message>
        <source>a triangle has a repeated vertex: remove degenerate triangles first</source>
        <translation>某个三角形有重复的顶点：请先移除退化三角形</translation>
    </message>
    <message>
        <source>more than two triangles share an edge: the surface would tear there</source>
        <translation>有一条边被两个以上三角形共用：表面会在该处撕裂</translation>
    </message>
    <message>
        <source>a vertex has too many triangles for this scheme: choose another</source>
        <translation>某个顶点的三角形数超出此方案的限制：请选择其他方案</translation>
    </message>
    <message>
        <source>the result would have too many triangles</source>
        <translation>结果的三角形过多</translation>
    </message>
    <message>
        <source>the precision of the file does not allow finer triangles</source>
        <translation>文件的精度不允许更细的三角形</translation>
    </message>
    <message>
        <source>Subdivide the mesh</source>
        <translation>细分网格</translation>
    </message>
    <message>
        <source>it is already in place</source>
        <translation>它已在该位置</translation>
    </message>
    <message>
        <source>it has no area</source>
        <translation>它没有面积</translation>
    </message>
    <message>
        <source>there is no flat face that the part can stand on</source>
        <translation>没有可供部件站立的平面</translation>
    </message>
    <message>
        <source>subdivide the mesh</source>
        <translation>细分网格</translation>
    </message>
    <message>
        <source>the numbers of the file cannot show such a thickness</source>
        <translation>文件的数值无法表示这样的厚度</translation>
    </message>
    <message>
        <source>no cut would separate the triangles cleanly; “Repair all” may replace them together with a hole</source>
        <translation>没有切割能干净地分开这些三角形；“全部修复”可能会将它们连同孔一起替换</translation>
    </message>
    <message>
        <source>Train a force model</source>
        <translation>训练切削力模型</translation>
    </message>
    <message>
        <source>Cutting force</source>
        <translation>切削力</translation>
    </message>
    <message>
        <source>Set up the lathe</source>
        <translation>设置车床</translation>
    </message>
    <message>
        <source>carriage to the chuck</source>
        <translation>大拖板移向卡盘</translation>
    </message>
    <message>
        <source>carriage away</source>
        <translation>大拖板移离卡盘</translation>
    </message>
    <message>
        <source>carriage by ten divisions to the chuck</source>
        <translation>大拖板移向卡盘十格</translation>
    </message>
    <message>
        <source>carriage by ten divisions away</source>
        <translation>大拖板移离卡盘十格</translation>
    </message>
    <message>
        <source>cross slide in</source>
        <translation>中拖板向内</translation>
    </message>
    <message>
        <source>cross slide out</source>
        <translation>中拖板向外</translation>
    </message>
    <message>
        <source>cross slide by ten divisions in</source>
        <translation>中拖板向内十格</translation>
    </message>
    <message>
        <source>cross slide by ten divisions out</source>
        <translation>中拖板向外十格</translation>
    </message>
    <message>
        <source>compound slide in</source>
        <translation>小拖板前进</translation>
    </message>
    <message>
        <source>compound slide out</source>
        <translation>小拖板后退</translation>
    </message>
    <message>
        <source>start or stop the spindle</source>
        <translation>启动或停止主轴</translation>
    </message>
    <message>
        <source>turn the tool post</source>
        <translation>转动刀架</translation>
    </message>
    <message>
        <source>stop the lathe</source>
        <translation>停止车床</translation>
    </message>
    <message>
        <source>move the tool</source>
        <translation>移动刀具</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>move the carriage</source>
        <translation>移动大拖板</translation>
    </message>
    <message>
        <source>move the cross slide</source>
        <translation>移动中拖板</translation>
    </message>
    <message>
        <source>move the compound slide</source>
        <translation>移动小拖板</translation>
    </message>
    <message>
        <source>by ten divisions</source>
        <translation>一次十格</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>螺纹</translation>
    </message>
    <message>
        <source>separating all of them would take too long for a mesh of this size</source>
        <translation>对于这种大小的网格，全部分离耗时过长</translation>
    </message>
    <message>
        <source>“Repair all” leaves them as they are; they can be fixed here</source>
        <translation>“全部修复”会保留它们原样；可在此处修复</translation>
    </message>
    <message>
        <source>merging them would make edges with more than two triangles</source>
        <translation>合并会产生连接两个以上三角形的边</translation>
    </message>
    <message>
        <source>a boundary that is to stay open goes through it</source>
        <translation>有一条需保持开放的边界从此处经过</translation>
    </message>
    <message>
        <source>it takes a cut longer than a hundredth of the model, which “Repair all” does not make; it can be made here</source>
        <translation>需要长度超过模型百分之一的切口，“全部修复”不会执行；可在此处执行</translation>
    </message>
    <message>
        <source>the cut would begin and end at an open edge, which “Repair all” does not make; it can be made here</source>
        <translation>切口的起点和终点都在开放边上，“全部修复”不会执行；可在此处执行</translation>
    </message>
    <message>
        <source>by a tenth of a division</source>
        <translation>移动十分之一格</translation>
    </message>
    <message>
        <source>rapid traverse while held</source>
        <translation>按住时快速移动</translation>
    </message>
    <message>
        <source>carriage by a tenth of a division to the chuck</source>
        <translation>大拖板向卡盘移动十分之一格</translation>
    </message>
    <message>
        <source>carriage by a tenth of a division away</source>
        <translation>大拖板离开卡盘移动十分之一格</translation>
    </message>
    <message>
        <source>carriage rapidly to the chuck, while held</source>
        <translation>按住时大拖板快速移向卡盘</translation>
    </message>
    <message>
        <source>carriage rapidly away, while held</source>
        <translation>按住时大拖板快速移离卡盘</translation>
    </message>
    <message>
        <source>cross slide by a tenth of a division in</source>
        <translation>中拖板向内移动十分之一格</translation>
    </message>
    <message>
        <source>cross slide by a tenth of a division out</source>
        <translation>中拖板向外移动十分之一格</translation>
    </message>
    <message>
        <source>cross slide rapidly in, while held</source>
        <translation>按住时中拖板快速向内移动</translation>
    </message>
    <message>
        <source>cross slide rapidly out, while held</source>
        <translation>按住时中拖板快速向外移动</translation>
    </message>
    <message>
        <source>Mount %1</source>
        <translation>安装%1</translation>
    </message>
    <message>
        <source>Take the tool off</source>
        <translation>卸下刀具</translation>
    </message>
    <message>
        <source>Round the target</source>
        <translation>圆整目标</translation>
    </message>
    <message>
        <source>Inverse kinematics</source>
        <translation>逆运动学</translation>
    </message>
    <message>
        <source>Planning benchmark</source>
        <translation>路径规划比较</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>位形</translation>
    </message>
    <message>
        <source>Plan path</source>
        <translation>规划路径</translation>
    </message>
    <message>
        <source>Plan process path</source>
        <translation>规划加工路径</translation>
    </message>
    <message>
        <source>plan the path along the curve</source>
        <translation>沿曲线规划路径</translation>
    </message>
    <message>
        <source>choose another curve</source>
        <translation>选择另一条曲线</translation>
    </message>
    <message>
        <source>choose a curve on a part</source>
        <translation>选择零件上的曲线</translation>
    </message>
    <message>
        <source>next way</source>
        <translation>下一种方式</translation>
    </message>
    <message>
        <source>previous way</source>
        <translation>上一种方式</translation>
    </message>
    <message>
        <source>move the robot there</source>
        <translation>将机器人移到此处</translation>
    </message>
    <message>
        <source>the cell is being prepared</source>
        <translation>单元正在准备中</translation>
    </message>
    <message>
        <source>this pose is out of reach</source>
        <translation>无法到达此位姿</translation>
    </message>
    <message>
        <source>a joint would be beyond its limits</source>
        <translation>会有关节超出限位</translation>
    </message>
    <message>
        <source>place the body there</source>
        <translation>将物体放到此处</translation>
    </message>
    <message>
        <source>choose another face</source>
        <translation>选择另一个面</translation>
    </message>
    <message>
        <source>choose a face of the body to be placed</source>
        <translation>选择要放置的物体的一个面</translation>
    </message>
    <message>
        <source>click a face of the body to be placed</source>
        <translation>单击要放置的物体的一个面</translation>
    </message>
    <message>
        <source>add this place to the path</source>
        <translation>将此位置添加到路径</translation>
    </message>
    <message>
        <source>lead the robot&apos;s tool</source>
        <translation>引导机器人的工具</translation>
    </message>
    <message>
        <source>turn the robot&apos;s tool</source>
        <translation>转动机器人的工具</translation>
    </message>
    <message>
        <source>Optimise path</source>
        <translation>优化路径</translation>
    </message>
    <message>
        <source>nothing is typed</source>
        <translation>未输入任何值</translation>
    </message>
    <message>
        <source>remove the last point</source>
        <translation>移除最后一点</translation>
    </message>
    <message>
        <source>draw the curve to there</source>
        <translation>将曲线画到此处</translation>
    </message>
    <message>
        <source>begin a curve on a part</source>
        <translation>在零件上开始一条曲线</translation>
    </message>
    <message>
        <source>draw in one go</source>
        <translation>一笔画成</translation>
    </message>
    <message>
        <source>too fast: feed %1 mm/rev, at most %2</source>
        <translation>过快：进给 %1 mm/r，最大 %2</translation>
    </message>
    <message>
        <source>Change robots</source>
        <translation>更改机器人</translation>
    </message>
    <message>
        <source>Make volume</source>
        <translation>生成体素模型</translation>
    </message>
    <message>
        <source>Make mesh</source>
        <translation>生成网格</translation>
    </message>
    <message>
        <source>place it there</source>
        <translation>放到此处</translation>
    </message>
    <message>
        <source>move it without snapping</source>
        <translation>移动（不吸附）</translation>
    </message>
    <message>
        <source>add clay</source>
        <translation>添加黏土</translation>
    </message>
    <message>
        <source>carve</source>
        <translation>挖去</translation>
    </message>
    <message>
        <source>move clay along</source>
        <translation>带动黏土移动</translation>
    </message>
    <message>
        <source>discard the stroke</source>
        <translation>放弃此笔</translation>
    </message>
    <message>
        <source>Add clay</source>
        <translation>添加黏土</translation>
    </message>
    <message>
        <source>Carve clay</source>
        <translation>挖去黏土</translation>
    </message>
    <message>
        <source>Inflate clay</source>
        <translation>膨胀黏土</translation>
    </message>
    <message>
        <source>Smooth clay</source>
        <translation>平滑黏土</translation>
    </message>
    <message>
        <source>Flatten clay</source>
        <translation>压平黏土</translation>
    </message>
    <message>
        <source>Move clay</source>
        <translation>移动黏土</translation>
    </message>
    <message>
        <source>Attract clay</source>
        <translation>吸引黏土</translation>
    </message>
    <message>
        <source>Pinch clay</source>
        <translation>捏合黏土</translation>
    </message>
    <message>
        <source>%1: %2 mm³</source>
        <translation>%1：%2 mm³</translation>
    </message>
    <message>
        <source>shape the clay</source>
        <translation>塑造黏土</translation>
    </message>
    <message>
        <source>discard the hole</source>
        <translation>放弃此孔</translation>
    </message>
    <message>
        <source>Drill: −%1 mm³, at most %2 N and %3 N·mm</source>
        <translation>钻孔：−%1 mm³，最大 %2 N 和 %3 N·mm</translation>
    </message>
    <message>
        <source>breakthrough: release the button</source>
        <translation>已钻穿：请松开按钮</translation>
    </message>
    <message>
        <source>drill across the surface</source>
        <translation>垂直于表面钻孔</translation>
    </message>
    <message>
        <source>drill along the view</source>
        <translation>沿视线方向钻孔</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>钻孔</translation>
    </message>
    <message>
        <source>Turning pass %1</source>
        <translation>车削走刀 %1</translation>
    </message>
    <message>
        <source>Segment image</source>
        <translation>分割图像</translation>
    </message>
    <message>
        <source>OpenMesh does not support two edges between the same vertices, as on one-sided surfaces: repair the mesh first</source>
        <translation>OpenMesh 不支持相同顶点之间有两条边（如单侧面上的情形）：请先修复网格</translation>
    </message>
    <message>
        <source>OpenMesh does not support two triangles back to back, a plate of zero thickness: delete them first</source>
        <translation>OpenMesh 不支持两个三角形背靠背（零厚度板）：请先将其删除</translation>
    </message>
    <message>
        <source>in the forbidden region: release the button</source>
        <translation>在禁区内：请松开按钮</translation>
    </message>
    <message>
        <source>beside the planned path</source>
        <translation>偏离规划路径</translation>
    </message>
    <message>
        <source>back to the current pose of the robot</source>
        <translation>返回机器人当前位形</translation>
    </message>
    <message>
        <source>the robot is already in this configuration</source>
        <translation>机器人已处于该位形</translation>
    </message>
    <message>
        <source>move a robot by its base</source>
        <translation>通过基座移动机器人</translation>
    </message>
    <message>
        <source>choose the face to place it on</source>
        <translation>选择要贴放到的面</translation>
    </message>
    <message>
        <source>click the face to place it on</source>
        <translation>单击要贴放到的面</translation>
    </message>
    <message>
        <source>move a body or a robot&apos;s base over the floor, along an arrow, turn by a ring</source>
        <translation>在地面上或沿箭头移动物体或机器人基座，绕圆环转动</translation>
    </message>
    <message>
        <source>move it up and down</source>
        <translation>上下移动</translation>
    </message>
    <message>
        <source>there are no triangles, or they have coordinates that are not numbers</source>
        <translation>没有三角形，或其坐标不是数字</translation>
    </message>
    <message>
        <source>Repair by volume</source>
        <translation>体素修复</translation>
    </message>
    <message>
        <source>repair by volume</source>
        <translation>体素修复</translation>
    </message>
    <message>
        <source>apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>combine with a file</source>
        <translation>与文件组合</translation>
    </message>
    <message>
        <source>there is no material</source>
        <translation>没有材料</translation>
    </message>
    <message>
        <source>no other body is open; choose a file</source>
        <translation>没有打开其他物体；请选择文件</translation>
    </message>
    <message>
        <source>it is being computed</source>
        <translation>正在计算</translation>
    </message>
    <message>
        <source>Combine volumes</source>
        <translation>组合体素模型</translation>
    </message>
    <message>
        <source>Close gaps</source>
        <translation>封闭间隙</translation>
    </message>
    <message>
        <source>Smooth volume</source>
        <translation>平滑体素模型</translation>
    </message>
    <message>
        <source>Make shell</source>
        <translation>抽壳</translation>
    </message>
    <message>
        <source>Move surface</source>
        <translation>偏移表面</translation>
    </message>
    <message>
        <source>all neighbours agree already</source>
        <translation>所有相邻三角形的方向已一致</translation>
    </message>
    <message>
        <source>it would take too long for a mesh of this size; “handwheel voxelize --wall” makes a volume with walls of any sheets</source>
        <translation>对于这样大小的网格，这会花费太长时间；“handwheel voxelize --wall”可由任意片体生成带壁的体素模型</translation>
    </message>
    <message>
        <source>Orient consistently</source>
        <translation>统一方向</translation>
    </message>
    <message>
        <source>no part is that small</source>
        <translation>没有这么小的部分</translation>
    </message>
    <message>
        <source>the surface encloses nothing, even with its holes closed: set a wall thickness to make walls of it</source>
        <translation>即使封闭孔洞，该曲面也不包围任何空间：请设置壁厚以生成壁</translation>
    </message>
    <message>
        <source>Unmask clay</source>
        <translation>取消黏土遮罩</translation>
    </message>
    <message>
        <source>Mask clay</source>
        <translation>遮罩黏土</translation>
    </message>
    <message>
        <source>mask clay</source>
        <translation>遮罩黏土</translation>
    </message>
    <message>
        <source>invert the mask</source>
        <translation>反转遮罩</translation>
    </message>
    <message>
        <source>clear the mask</source>
        <translation>清除遮罩</translation>
    </message>
    <message>
        <source>load a stamp</source>
        <translation>加载印章</translation>
    </message>
    <message>
        <source>Invert the mask</source>
        <translation>反转遮罩</translation>
    </message>
    <message>
        <source>Clear the mask</source>
        <translation>清除遮罩</translation>
    </message>
    <message>
        <source>nothing is masked</source>
        <translation>没有任何遮罩</translation>
    </message>
    <message>
        <source>the drill would cut sideways here: begin on a free surface</source>
        <translation>钻头在此会侧向切削：请从空闲的表面开始</translation>
    </message>
    <message>
        <source>Unite bodies</source>
        <translation>合并实体</translation>
    </message>
    <message>
        <source>only closed bodies can be united: close holes and open sheets, and reverse bodies that are inside out before</source>
        <translation>只能合并封闭的体：请先封闭孔洞和开放片，并翻转内外颠倒的体</translation>
    </message>
    <message>
        <source>pull a place of a path</source>
        <translation>拉动路径的位置</translation>
    </message>
    <message>
        <source>Smudge clay</source>
        <translation>涂抹黏土</translation>
    </message>
    <message>
        <source>hold the feed</source>
        <translation>暂停进给</translation>
    </message>
    <message>
        <source>the feed is held</source>
        <translation>进给已暂停</translation>
    </message>
    <message>
        <source>go on with the feed</source>
        <translation>继续进给</translation>
    </message>
    <message>
        <source>Measuring the mesh</source>
        <translation>正在测量网格</translation>
    </message>
    <message>
        <source>the mesh is being measured</source>
        <translation>正在测量网格</translation>
    </message>
    <message>
        <source>Shape clay</source>
        <translation>塑泥</translation>
    </message>
    <message>
        <source>select a body, robot or frame</source>
        <translation>请选择物体、机器人或坐标系</translation>
    </message>
    <message>
        <source>the top layer is off, or weaker than 1</source>
        <translation>最上层已关闭或强度小于 1</translation>
    </message>
    <message>
        <source>the mesh is not closed, or not manifold</source>
        <translation>网格不封闭或非流形</translation>
    </message>
    <message>
        <source>triangles of the mesh intersect one another</source>
        <translation>网格的三角形彼此相交</translation>
    </message>
    <message>
        <source>the hole meets too many triangles</source>
        <translation>孔涉及的三角形过多</translation>
    </message>
    <message>
        <source>the triangles cannot be joined soundly along the hole</source>
        <translation>三角形无法沿孔边完好连接</translation>
    </message>
    <message>
        <source>nothing would be left of the mesh</source>
        <translation>网格将不剩任何部分</translation>
    </message>
    <message>
        <source>Drill a hole</source>
        <translation>钻孔</translation>
    </message>
    <message>
        <source>the mesh was changed meanwhile</source>
        <translation>网格在此期间已更改</translation>
    </message>
    <message>
        <source>there are no triangles</source>
        <translation>没有三角形</translation>
    </message>
    <message>
        <source>the mesh has holes, so it has no inside: close them first</source>
        <translation>网格有孔洞，因此没有内部：请先封闭</translation>
    </message>
    <message>
        <source>the mesh is not manifold: repair it first</source>
        <translation>网格非流形：请先修复</translation>
    </message>
    <message>
        <source>a body is inside out: turn it over first</source>
        <translation>有一个实体内外翻转：请先翻转</translation>
    </message>
    <message>
        <source>the voxels are too small for a part of this size</source>
        <translation>对于这种尺寸的零件，体素太小</translation>
    </message>
    <message>
        <source>the surface encloses nothing</source>
        <translation>曲面没有包围任何空间</translation>
    </message>
    <message>
        <source>there are coordinates that are not numbers</source>
        <translation>有些坐标不是数字</translation>
    </message>
    <message>
        <source>bodies overlap here, or a wall is thinner than a voxel: near the drill alone this cannot be drilled</source>
        <translation>此处有实体重叠，或壁厚小于一个体素：无法仅在钻头附近钻孔</translation>
    </message>
    <message>
        <source>triangles of the mesh intersect one another: resolve that first</source>
        <translation>网格的三角形彼此相交：请先解决</translation>
    </message>
    <message>
        <source>Preparing to drill</source>
        <translation>正在准备钻孔</translation>
    </message>
    <message>
        <source>the hole is being taken from the triangles</source>
        <translation>正在从三角形中切除孔</translation>
    </message>
    <message>
        <source>the mesh is being prepared for the drill</source>
        <translation>正在为钻头准备网格</translation>
    </message>
    <message>
        <source>Pass %1</source>
        <translation>走刀 %1</translation>
    </message>
    <message>
        <source>Plunging pass %1</source>
        <translation>切入走刀 %1</translation>
    </message>
    <message>
        <source>Threading pass %1</source>
        <translation>螺纹走刀 %1</translation>
    </message>
    <message>
        <source>Boring pass %1</source>
        <translation>镗削走刀 %1</translation>
    </message>
    <message>
        <source>Drilling pass %1</source>
        <translation>钻削走刀 %1</translation>
    </message>
    <message>
        <source>Filing pass %1</source>
        <translation>锉削走刀 %1</translation>
    </message>
    <message>
        <source>Grinding pass %1</source>
        <translation>磨削走刀 %1</translation>
    </message>
    <message>
        <source>%1: −%2 mm³</source>
        <translation>%1：−%2 mm³</translation>
    </message>
    <message>
        <source>this volume is to be drilled, not shaped</source>
        <translation>此体素模型用于钻孔，而非塑形</translation>
    </message>
    <message>
        <source>no two vertices can be merged so that an open edge closes and none gets a third triangle</source>
        <translation>没有任何两个顶点可以合并，使开放边闭合且不产生连接第三个三角形的边</translation>
    </message>
    <message>
        <source>Refining</source>
        <translation>正在细化</translation>
    </message>
</context>
<context>
    <name>ToolInput</name>
    <message>
        <source>Click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Shift+单击</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+单击</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>拖动</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Shift+拖动</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+拖动</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>松开</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>按住</translation>
    </message>
    <message>
        <source>Shift+hold</source>
        <translation>Shift+按住</translation>
    </message>
</context>
<context>
    <name>ToolReadout</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1 – limit (%2)</source>
        <translation>%1 – 极限（%2）</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
</context>
<context>
    <name>WindowServices</name>
    <message>
        <source>Autosave</source>
        <translation>自动保存</translation>
    </message>
    <message>
        <source>Search for self-intersections</source>
        <translation>自相交查找</translation>
    </message>
    <message>
        <source>Preview of the patch</source>
        <translation>补片预览</translation>
    </message>
    <message>
        <source>Servo loop of the device</source>
        <translation>设备的伺服循环</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>仿真</translation>
    </message>
</context>
<context>
    <name>handwheel::Autosave</name>
    <message>
        <source>Autosaving %1</source>
        <translation>正在自动保存 %1</translation>
    </message>
    <message numerus="yes">
        <source>Handwheel ended unexpectedly. %Ln document(s) had changes that were not saved.</source>
        <translation>
            <numerusform>Handwheel 意外退出。%Ln 个文档有未保存的更改。</numerusform>
        </translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>%1 (its file was saved since)</source>
        <translation>%1(其文件此后已保存)</translation>
    </message>
    <message>
        <source>%1 could not be autosaved</source>
        <translation>无法自动保存 %1</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message numerus="yes">
        <source>%Ln autosave(s) of a session that ended unexpectedly cannot be read.</source>
        <translation>
            <numerusform>意外结束的会话留下的 %Ln 个自动保存无法读取。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Discarded %Ln autosave(s)</source>
        <translation>
            <numerusform>已丢弃 %Ln 个自动保存</numerusform>
        </translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>丢弃…</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Save it now: if the program ended unexpectedly, your last changes would be lost.</source>
        <translation>请立即保存：如果程序意外结束，您最近的更改将会丢失。</translation>
    </message>
    <message>
        <source>They can be recovered as they were last autosaved, or discarded permanently; otherwise they are offered again at the next start.</source>
        <translation>可以恢复到最后一次自动保存的状态，也可以永久丢弃；否则下次启动时会再次提示。</translation>
    </message>
    <message numerus="yes">
        <source>Discard %Ln document(s) permanently?</source>
        <translation>
            <numerusform>永久丢弃 %Ln 个文档？</numerusform>
        </translation>
    </message>
    <message>
        <source>Their changes since they were last saved cannot be recovered.</source>
        <translation>自上次保存以来的更改将无法恢复。</translation>
    </message>
    <message>
        <source>Their contents are lost. They are kept until you discard them.</source>
        <translation>其内容已丢失。它们会一直保留，直到您将其丢弃。</translation>
    </message>
    <message>
        <source>The files are listed in the Log.</source>
        <translation>日志中列出了这些文件。</translation>
    </message>
</context>
<context>
    <name>handwheel::AxisBars</name>
    <message>
        <source>Position and orientation</source>
        <translation>位置与方向</translation>
    </message>
    <message>
        <source>Grip</source>
        <translation>手柄</translation>
    </message>
    <message>
        <source>Drag a knob to move the simulated hand; with keys: arrows, finer with Ctrl, Page Up and Down, Home</source>
        <translation>拖动滑块可移动模拟手；键盘：方向键，按住 Ctrl 更精细，Page Up 和 Page Down，Home</translation>
    </message>
</context>
<context>
    <name>handwheel::BenchmarkRunner</name>
    <message>
        <source>the file is damaged.</source>
        <translation>文件已损坏。</translation>
    </message>
    <message>
        <source>The measurements of this machine cannot be used: %1</source>
        <translation>本机的测量结果无法使用：%1</translation>
    </message>
    <message>
        <source>The stored measurements are from another machine (%1).</source>
        <translation>已存储的测量结果来自另一台机器（%1）。</translation>
    </message>
    <message>
        <source>The measurements could not be saved: %1</source>
        <translation>无法保存测量结果：%1</translation>
    </message>
</context>
<context>
    <name>handwheel::BodyList</name>
    <message>
        <source>Bodies</source>
        <translation>物体</translation>
    </message>
</context>
<context>
    <name>handwheel::BodyModel</name>
    <message>
        <source>%1, hidden</source>
        <translation>%1，已隐藏</translation>
    </message>
    <message>
        <source>Linked to %1, which is missing</source>
        <translation>链接到 %1（缺失）</translation>
    </message>
    <message>
        <source>Linked to %1, which has changed since it was read</source>
        <translation>链接到 %1（读取后已更改）</translation>
    </message>
    <message>
        <source>Linked to %1</source>
        <translation>链接到 %1</translation>
    </message>
    <message>
        <source>Hide the body</source>
        <translation>隐藏物体</translation>
    </message>
    <message>
        <source>Show the body</source>
        <translation>显示物体</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Drop bodies here for %1 to carry them</source>
        <translation>将物体拖放到此处，由 %1 携带</translation>
    </message>
</context>
<context>
    <name>handwheel::ButtonLamps</name>
    <message>
        <source>Buttons</source>
        <translation>按钮</translation>
    </message>
    <message>
        <source>No button is held</source>
        <translation>没有按下按钮</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>按住：%1</translation>
    </message>
    <message>
        <source>Click to hold a button of the simulated hand, and again to release it; or press its number</source>
        <translation>单击以按住模拟手的按钮，再次单击以松开；或按其数字键</translation>
    </message>
</context>
<context>
    <name>handwheel::CalibrationRow</name>
    <message>
        <source>Measuring this machine</source>
        <translation>正在测量本机</translation>
    </message>
    <message>
        <source>Measuring this machine: %1</source>
        <translation>正在测量本机：%1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Measure this machine</source>
        <translation>测量本机</translation>
    </message>
    <message>
        <source>Takes about half a minute. You can go on working.</source>
        <translation>大约需要半分钟。您可以继续工作。</translation>
    </message>
    <message>
        <source>The curves were supplied with the program: %1, %2.</source>
        <translation>曲线随程序提供：%1，%2。</translation>
    </message>
    <message>
        <source>The curves were measured on this machine, %1.</source>
        <translation>曲线在本机测得，%1。</translation>
    </message>
    <message>
        <source>%1 of %2 curves were measured on this machine.</source>
        <translation>%2 条曲线中有 %1 条在本机测得。</translation>
    </message>
</context>
<context>
    <name>handwheel::CellBodies</name>
    <message>
        <source>Add a body</source>
        <translation>添加物体</translation>
    </message>
    <message>
        <source>Add a &amp;shape</source>
        <translation>添加形状(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Add a body from a file…</source>
        <translation>从文件添加物体(&amp;A)…</translation>
    </message>
    <message>
        <source>Add a body &amp;linked to a file…</source>
        <translation>添加链接到文件的物体(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Remove the body</source>
        <translation>移除物体(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Hide the body</source>
        <translation>隐藏物体(&amp;H)</translation>
    </message>
    <message>
        <source>Show all &amp;bodies</source>
        <translation>显示所有物体(&amp;B)</translation>
    </message>
    <message>
        <source>Read the linked file a&amp;gain</source>
        <translation>重新读取链接的文件(&amp;G)</translation>
    </message>
    <message>
        <source>Show all bodies that are hidden</source>
        <translation>显示所有隐藏的物体</translation>
    </message>
    <message>
        <source>Add a linked body</source>
        <translation>添加链接的物体</translation>
    </message>
    <message>
        <source>Nothing has changed</source>
        <translation>没有任何更改</translation>
    </message>
    <message>
        <source>Link to an&amp;other file…</source>
        <translation>链接到其他文件(&amp;O)…</translation>
    </message>
    <message>
        <source>Remove the selected bodies from the cell</source>
        <translation>从单元中移除所选物体</translation>
    </message>
    <message>
        <source>Open a robot cell first.</source>
        <translation>请先打开机器人单元。</translation>
    </message>
    <message>
        <source>Select a body first, in the view or in the list.</source>
        <translation>请先在视图或列表中选择一个物体。</translation>
    </message>
    <message>
        <source>It is hidden.</source>
        <translation>它已隐藏。</translation>
    </message>
    <message>
        <source>No body is hidden.</source>
        <translation>没有隐藏的物体。</translation>
    </message>
    <message>
        <source>Select one body only.</source>
        <translation>请只选择一个物体。</translation>
    </message>
    <message>
        <source>The body is not linked to a file.</source>
        <translation>该物体未链接到文件。</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Link %1 to another file</source>
        <translation>将 %1 链接到其他文件</translation>
    </message>
    <message>
        <source>Read the file of %1 again</source>
        <translation>重新读取 %1 的文件</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>显示 %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>隐藏 %1</translation>
    </message>
    <message>
        <source>Show the bodies</source>
        <translation>显示物体</translation>
    </message>
    <message>
        <source>Hide the bodies</source>
        <translation>隐藏物体</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>Unlink the &amp;file</source>
        <translation>取消与文件的链接(&amp;F)</translation>
    </message>
    <message>
        <source>Add the shape of another file beside the robot</source>
        <translation>在机器人旁添加另一文件的形状</translation>
    </message>
    <message>
        <source>Add the shape of another file and link to the file, to read it again when it has changed</source>
        <translation>添加另一文件的形状并链接到该文件，以便更改后重新读取</translation>
    </message>
    <message>
        <source>Hide the selected bodies from view and touch</source>
        <translation>隐藏所选物体，且不可触及</translation>
    </message>
    <message>
        <source>Read the file that the selected body is linked to again</source>
        <translation>再次读取所选物体链接的文件</translation>
    </message>
    <message>
        <source>Use the shape of another file; name, position and colour are kept</source>
        <translation>采用另一文件的形状；名称、位置和颜色不变</translation>
    </message>
    <message>
        <source>Keep the selected body as it is, without a link to its file</source>
        <translation>保持所选物体不变，并取消与其文件的链接</translation>
    </message>
    <message>
        <source>Add a body of this shape beside the robot</source>
        <translation>在机器人旁添加此形状的物体</translation>
    </message>
    <message>
        <source>Unlink the file of %1</source>
        <translation>取消 %1 的文件链接</translation>
    </message>
    <message>
        <source>&amp;Mount the body on the tool flange</source>
        <translation>将物体安装到工具法兰(&amp;M)</translation>
    </message>
    <message>
        <source>Take the body off the &amp;robot</source>
        <translation>将物体从机器人上取下(&amp;R)</translation>
    </message>
    <message>
        <source>The robot does not carry it.</source>
        <translation>机器人没有携带它。</translation>
    </message>
    <message>
        <source>Mount %1 on %2</source>
        <translation>将 %1 安装到 %2</translation>
    </message>
    <message>
        <source>Release %1</source>
        <translation>放下 %1</translation>
    </message>
    <message>
        <source>Re&amp;name the body</source>
        <translation>重命名物体(&amp;N)</translation>
    </message>
    <message>
        <source>Choose the &amp;unit of its numbers…</source>
        <translation>选择其数值的单位(&amp;U)…</translation>
    </message>
    <message>
        <source>Give the selected body another name, in the list</source>
        <translation>在列表中为所选物体指定其他名称</translation>
    </message>
    <message>
        <source>Unlink the file first: it is read again with its own numbers.</source>
        <translation>请先取消与文件的链接：文件会按其自身的数值重新读取。</translation>
    </message>
    <message>
        <source>Only bodies from mesh files have numbers without a unit.</source>
        <translation>只有来自网格文件的物体才有不带单位的数值。</translation>
    </message>
    <message>
        <source>%1: the body measures %2</source>
        <translation>%1：物体尺寸为 %2</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>%1 的单位</translation>
    </message>
    <message>
        <source>Its numbers are in:</source>
        <translation>其数值的单位：</translation>
    </message>
    <message>
        <source>Scaling %1</source>
        <translation>正在缩放 %1</translation>
    </message>
    <message>
        <source>Change the unit of %1</source>
        <translation>更改 %1 的单位</translation>
    </message>
    <message>
        <source>%1 measures %2</source>
        <translation>%1 的尺寸为 %2</translation>
    </message>
    <message>
        <source>%1 has no unit; its numbers were taken as millimetres.</source>
        <translation>%1 没有单位；其数值已按毫米处理。</translation>
    </message>
    <message>
        <source>Choose the unit…</source>
        <translation>选择单位…</translation>
    </message>
    <message>
        <source>Specify the unit of the numbers of its file: STL, OBJ, PLY and OFF have none and are taken as mm</source>
        <translation>指定其文件中数值的单位：STL、OBJ、PLY 和 OFF 没有单位，按 mm 处理</translation>
    </message>
    <message>
        <source>Attach the selected body to the robot as a tool, with its origin at the flange</source>
        <translation>将所选物体作为工具安装到机器人上，其原点位于法兰处</translation>
    </message>
    <message>
        <source>Detach the selected body from the robot and leave it where it is</source>
        <translation>将所选物体从机器人上卸下，并留在原处</translation>
    </message>
    <message>
        <source>The bodies were not changed</source>
        <translation>物体未更改</translation>
    </message>
    <message numerus="yes">
        <source>%n body(ies)</source>
        <translation>
            <numerusform>%n 个物体</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing carries %1, as before</source>
        <translation>与之前一样，没有部件携带 %1</translation>
    </message>
    <message>
        <source>Only links of robots carry bodies; a body carries none.</source>
        <translation>只有机器人的连杆能携带物体；物体不能携带物体。</translation>
    </message>
    <message>
        <source>Drop it on a link, or on a body that a link carries.</source>
        <translation>请将其拖放到连杆上，或拖放到由连杆携带的物体上。</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>将 %1 附着到 %2</translation>
    </message>
    <message>
        <source>&amp;Place it beside the others</source>
        <translation>放到其他物体旁(&amp;P)</translation>
    </message>
    <message>
        <source>Tool &amp;centre point at its tip</source>
        <translation>工具中心点设在其尖端(&amp;C)</translation>
    </message>
    <message>
        <source>Put the selected body in front of the robot and of all other bodies, on the floor</source>
        <translation>将选中的物体放在机器人及所有其他物体前方的地面上</translation>
    </message>
    <message>
        <source>Put the tool centre point in the middle of what reaches farthest along the Z axis of the flange</source>
        <translation>将工具中心点设在沿法兰 Z 轴伸出最远处的中心</translation>
    </message>
    <message>
        <source>A link of the robot carries it.</source>
        <translation>它由机器人的连杆承载。</translation>
    </message>
    <message>
        <source>The flange does not carry it.</source>
        <translation>它不由法兰承载。</translation>
    </message>
    <message>
        <source>Place %1 beside the others</source>
        <translation>将 %1 放到其他物体旁</translation>
    </message>
    <message>
        <source>%1 was mounted on %2</source>
        <translation>%1 已安装到 %2</translation>
    </message>
    <message>
        <source>The tool centre point is where it was; it is a group of fields in the panel.</source>
        <translation>工具中心点保持原位；它是面板中的一组字段。</translation>
    </message>
    <message>
        <source>Tool centre point at the tip of %1</source>
        <translation>工具中心点在 %1 的尖端</translation>
    </message>
    <message>
        <source>Place %1 where its file says</source>
        <translation>按文件中的位置放置 %1</translation>
    </message>
    <message>
        <source>%1 was placed beside the others</source>
        <translation>已将 %1 放在其他物体旁边</translation>
    </message>
    <message>
        <source>Where its file says, it would be inside something else: it was placed beside the others.</source>
        <translation>按文件中的位置，它会在别的物体内部：已放在其他物体旁边。</translation>
    </message>
    <message>
        <source>&amp;Place it where its file says</source>
        <translation>按文件中的位置放置(&amp;P)</translation>
    </message>
</context>
<context>
    <name>handwheel::CellCollisions</name>
    <message>
        <source>Preparing the cell for collisions</source>
        <translation>正在为碰撞检测准备单元</translation>
    </message>
</context>
<context>
    <name>handwheel::CellContactMarks</name>
    <message>
        <source>Show where things to&amp;uch</source>
        <translation>显示接触位置(&amp;U)</translation>
    </message>
    <message>
        <source>Mark the places where links and bodies collide, with the way out of each other</source>
        <translation>标记连杆与物体碰撞的位置及其分离方向</translation>
    </message>
</context>
<context>
    <name>handwheel::CellPaths</name>
    <message>
        <source>&amp;Store this configuration</source>
        <translation>保存此位形(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Go to it</source>
        <translation>前往(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Plan a path…</source>
        <translation>规划路径(&amp;P)…</translation>
    </message>
    <message>
        <source>Plan the path &amp;again</source>
        <translation>重新规划路径(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Insert this configuration into the path</source>
        <translation>将此位形插入路径(&amp;I)</translation>
    </message>
    <message>
        <source>Set the place to &amp;here</source>
        <translation>将位置设为此处(&amp;H)</translation>
    </message>
    <message>
        <source>Move the place &amp;up</source>
        <translation>位置上移(&amp;U)</translation>
    </message>
    <message>
        <source>Move the place &amp;down</source>
        <translation>位置下移(&amp;D)</translation>
    </message>
    <message>
        <source>Straight &amp;line to the place</source>
        <translation>直线到该位置(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Verify the path</source>
        <translation>验证路径(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Export a robot program…</source>
        <translation>导出机器人程序(&amp;E)…</translation>
    </message>
    <message>
        <source>Open a robot program as a pa&amp;th…</source>
        <translation>将机器人程序作为路径打开(&amp;T)…</translation>
    </message>
    <message>
        <source>Read allowed pairs (S&amp;RDF)…</source>
        <translation>读取允许接触的对 (S&amp;RDF)…</translation>
    </message>
    <message>
        <source>Plan a path between configurations that is proven free of collisions</source>
        <translation>在位形之间规划一条已证明无碰撞的路径</translation>
    </message>
    <message>
        <source>Move the tool&apos;s centre point to the place along a straight line</source>
        <translation>使工具中心点沿直线移到该位置</translation>
    </message>
    <message>
        <source>Write the path for a controller (RAPID, KRL, Fanuc, URScript, CSV, JSON), if it is free of collisions</source>
        <translation>将无碰撞的路径写为控制器程序（RAPID、KRL、Fanuc、URScript、CSV、JSON）</translation>
    </message>
    <message>
        <source>Read a program of a controller as a path of this cell</source>
        <translation>将控制器程序读为此单元的路径</translation>
    </message>
    <message>
        <source>Open a robot program</source>
        <translation>打开机器人程序</translation>
    </message>
    <message>
        <source>Robot programs (*.mod *.src *.ls *.script *.csv *.json);;All files (*)</source>
        <translation>机器人程序 (*.mod *.src *.ls *.script *.csv *.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Read allowed pairs</source>
        <translation>读取允许接触的对</translation>
    </message>
    <message>
        <source>Semantic descriptions (*.srdf *.xml);;All files (*)</source>
        <translation>语义描述 (*.srdf *.xml);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Open a robot cell first.</source>
        <translation>请先打开一个机器人单元。</translation>
    </message>
    <message>
        <source>Select a place of a path first.</source>
        <translation>请先选择路径上的位置。</translation>
    </message>
    <message>
        <source>Select a path first.</source>
        <translation>请先选择路径。</translation>
    </message>
    <message>
        <source>Only a path that is proven free of collisions is exported.</source>
        <translation>只导出已证明无碰撞的路径。</translation>
    </message>
    <message>
        <source>This could not be done</source>
        <translation>无法完成</translation>
    </message>
    <message>
        <source>Configuration %1</source>
        <translation>位形 %1</translation>
    </message>
    <message>
        <source>Store %1</source>
        <translation>保存 %1</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>前往 %1</translation>
    </message>
    <message>
        <source>Go to place %1 of %2</source>
        <translation>前往 %2 的位置 %1</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Plan %1</source>
        <translation>规划 %1</translation>
    </message>
    <message>
        <source>Plan %1 again</source>
        <translation>重新规划 %1</translation>
    </message>
    <message>
        <source>The cell is still being prepared</source>
        <translation>单元仍在准备中</translation>
    </message>
    <message>
        <source>Planning %1</source>
        <translation>正在规划 %1</translation>
    </message>
    <message>
        <source>Insert a place into %1</source>
        <translation>在 %1 中插入位置</translation>
    </message>
    <message>
        <source>Set place %1 of %2</source>
        <translation>设置 %2 的位置 %1</translation>
    </message>
    <message>
        <source>Move place %1 of %2</source>
        <translation>移动 %2 的位置 %1</translation>
    </message>
    <message>
        <source>Straight line to place %1</source>
        <translation>直线到位置 %1</translation>
    </message>
    <message>
        <source>Joint motion to place %1</source>
        <translation>以关节运动到位置 %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Remove place %1 of %2</source>
        <translation>移除 %2 的位置 %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Export a robot program</source>
        <translation>导出机器人程序</translation>
    </message>
    <message numerus="yes">
        <source>%Ln motion(s), read back within %1 mm.</source>
        <translation>
            <numerusform>%Ln 个运动，回读误差在 %1 mm 以内。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was written</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>加工</translation>
    </message>
    <message>
        <source>Optimising %1</source>
        <translation>正在优化 %1</translation>
    </message>
    <message>
        <source>Optimise %1</source>
        <translation>优化 %1</translation>
    </message>
    <message>
        <source>Cycle time %1 s before, %2 s now.</source>
        <translation>循环时间：之前 %1 s，现在 %2 s。</translation>
    </message>
    <message>
        <source>The places are in another order.</source>
        <translation>各位置的顺序已改变。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln place(s) in another configuration of the arm.</source>
        <translation>
            <numerusform>%Ln 个位置采用了机械臂的其他位形。</numerusform>
        </translation>
    </message>
    <message>
        <source>No other order or configuration takes less than its %1 s.</source>
        <translation>没有其他顺序或位形的用时少于其 %1 s。</translation>
    </message>
    <message>
        <source>%1 was optimised</source>
        <translation>%1 已优化</translation>
    </message>
    <message>
        <source>Store a &amp;target here</source>
        <translation>在此处保存目标点(&amp;T)</translation>
    </message>
    <message>
        <source>Optimise the order and &amp;configurations</source>
        <translation>优化顺序和位形(&amp;C)</translation>
    </message>
    <message>
        <source>Move the robot to the selected configuration, place or target</source>
        <translation>将机器人移到所选的位形、位置或目标点</translation>
    </message>
    <message>
        <source>Store a configuration or a target first: where the path is to begin or end.</source>
        <translation>请先保存位形或目标点，作为路径的起点或终点。</translation>
    </message>
    <message>
        <source>Select a configuration, a place or a target first.</source>
        <translation>请先选择位形、位置或目标点。</translation>
    </message>
    <message>
        <source>There is nothing between the ends of the path.</source>
        <translation>路径的两端之间没有任何位置。</translation>
    </message>
    <message>
        <source>Try again in a moment.</source>
        <translation>请稍后再试。</translation>
    </message>
    <message>
        <source>Target %1</source>
        <translation>目标点 %1</translation>
    </message>
    <message>
        <source>Store %1 on %2</source>
        <translation>将 %1 保存到 %2 上</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>设置 %1</translation>
    </message>
    <message>
        <source>Begin a path</source>
        <translation>开始一条路径</translation>
    </message>
    <message>
        <source>%1 is not the language of the controller of this robot, %2.</source>
        <translation>%1 不是此机器人（%2）的控制器所用的语言。</translation>
    </message>
    <message>
        <source>%1 was changed while it was planned</source>
        <translation>%1 在规划期间被更改</translation>
    </message>
    <message>
        <source>The cell was changed while %1 was planned</source>
        <translation>规划 %1 期间单元被更改</translation>
    </message>
    <message>
        <source>Plan it again</source>
        <translation>重新规划</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>正在写入 %1</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>Plan for this ro&amp;bot</source>
        <translation>为此机器人规划(&amp;B)</translation>
    </message>
    <message>
        <source>Plan the path again through its critical places; one along a curve follows it where the part is now</source>
        <translation>经过关键位置重新规划路径；沿曲线的路径会按零件的当前位置跟随该曲线</translation>
    </message>
    <message>
        <source>Select a robot in the list first, in a cell with several.</source>
        <translation>在含多个机器人的单元中，请先在列表中选择一个机器人。</translation>
    </message>
    <message>
        <source>%1 was verified: %2</source>
        <translation>%1 已验证：%2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln motion(s)</source>
        <translation>
            <numerusform>%Ln 个运动</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be planned</source>
        <translation>无法规划 %1</translation>
    </message>
    <message>
        <source>Change the process of %1</source>
        <translation>更改 %1 的加工参数</translation>
    </message>
    <message>
        <source>Save in:</source>
        <translation>保存到：</translation>
    </message>
    <message>
        <source>%1 is there already</source>
        <translation>%1 已存在</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Verif&amp;y all paths</source>
        <translation>验证所有路径(&amp;Y)</translation>
    </message>
    <message>
        <source>The cell has no path yet.</source>
        <translation>单元中还没有路径。</translation>
    </message>
    <message>
        <source>Read %1 for %2</source>
        <translation>为 %2 读取 %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of links that may touch</source>
        <translation>
            <numerusform>%Ln 对允许接触的连杆</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln named state(s).</source>
        <translation>
            <numerusform>%Ln 个命名状态。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln entry(ies) name links or joints that the robot does not have, and were left out; see the log.</source>
        <translation>
            <numerusform>%Ln 个条目引用了机器人没有的连杆或关节，已略去；见日志。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was read for %2</source>
        <translation>已为 %2 读取 %1</translation>
    </message>
    <message>
        <source>%1 was planned</source>
        <translation>已规划 %1</translation>
    </message>
    <message numerus="yes">
        <source>It has %Ln place(s), and is selected in the list.</source>
        <translation>
            <numerusform>它有 %Ln 个位置，已在列表中选中。</numerusform>
        </translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>重命名(&amp;N)</translation>
    </message>
    <message>
        <source>Remo&amp;ve from the plan</source>
        <translation>从规划中移除(&amp;V)</translation>
    </message>
    <message>
        <source>%1 was stored</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>It is selected in the list.</source>
        <translation>它已在列表中选中。</translation>
    </message>
    <message>
        <source>It moves with %1.</source>
        <translation>它随 %1 移动。</translation>
    </message>
    <message>
        <source>Place %1 of %2 was stored</source>
        <translation>已保存 %2 的位置 %1</translation>
    </message>
    <message numerus="yes">
        <source>The path has %Ln place(s) now.</source>
        <translation>
            <numerusform>路径现在有 %Ln 个位置。</numerusform>
        </translation>
    </message>
    <message>
        <source>Place 1 of %1 was stored</source>
        <translation>已保存 %1 的位置 1</translation>
    </message>
    <message>
        <source>The next places that are stored continue the path.</source>
        <translation>接下来保存的位置将延续该路径。</translation>
    </message>
    <message>
        <source>%1 was not changed</source>
        <translation>%1 未更改</translation>
    </message>
    <message numerus="yes">
        <source>%Ln point(s) checked.</source>
        <translation>
            <numerusform>已检查 %Ln 个点。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln path(s) proven</source>
        <translation>
            <numerusform>已证明 %Ln 条路径</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln not</source>
        <translation>
            <numerusform>%Ln 条未证明</numerusform>
        </translation>
    </message>
    <message>
        <source>The list has what is known of the others.</source>
        <translation>列表中有其他路径的已知情况。</translation>
    </message>
    <message>
        <source>%1 could not be planned again and was not changed</source>
        <translation>%1 无法重新规划，未作更改</translation>
    </message>
    <message>
        <source>Your changes were kept; the planned path is %1.</source>
        <translation>您的更改已保留；规划出的路径为 %1。</translation>
    </message>
    <message>
        <source>The result is not valid for the cell as it is now, and was discarded.</source>
        <translation>结果不适用于单元的当前状态，已被丢弃。</translation>
    </message>
    <message>
        <source>%1 is outdated</source>
        <translation>%1 已过时</translation>
    </message>
    <message>
        <source>%1 is not proven as it is now</source>
        <translation>%1 的当前状态未经证明</translation>
    </message>
    <message>
        <source>Only what is proven free of collisions is exported.</source>
        <translation>只导出已证明无碰撞的内容。</translation>
    </message>
    <message>
        <source>Export it as it is</source>
        <translation>按原样导出</translation>
    </message>
    <message>
        <source>The name had no extension of a robot language, so that of %1 was added.</source>
        <translation>名称没有任何机器人语言的扩展名，因此添加了 %1 的扩展名。</translation>
    </message>
    <message>
        <source>Store the current joint values under a name</source>
        <translation>以名称保存当前关节值</translation>
    </message>
    <message>
        <source>Insert the current joint values after the selected place as a critical configuration; before the goal, if that or the path is selected</source>
        <translation>将当前关节值作为关键位形插入到所选位置之后；若所选为终点或路径，则插入到终点之前</translation>
    </message>
    <message>
        <source>Move the selected place towards the start of the path</source>
        <translation>将所选位置向路径起点移动</translation>
    </message>
    <message>
        <source>Move the selected place towards the end of the path</source>
        <translation>将所选位置向路径终点移动</translation>
    </message>
    <message>
        <source>Verify that each motion of the selected path is free of collisions, or list all collisions; also if it was verified before</source>
        <translation>验证所选路径的每个运动均无碰撞，或列出所有碰撞；已验证过的也会重新验证</translation>
    </message>
    <message>
        <source>Verify the paths of all robots that are not verified in their current state, each with the other robots where they are</source>
        <translation>验证所有机器人中当前状态尚未验证的路径，验证时其他机器人均处于当前位置</translation>
    </message>
    <message>
        <source>Read the pairs of links that may touch, and named states, of the selected robot, or else of the one to plan for</source>
        <translation>读取所选机器人（未选择时为要规划的机器人）的允许接触的连杆对和命名状态</translation>
    </message>
    <message>
        <source>Choose the order of the critical places, and the configurations in which they are reached, that take the least time</source>
        <translation>选择用时最少的关键位置顺序和到达各位置的位形</translation>
    </message>
    <message>
        <source>Plan for the selected robot from now on; the others stay where they are</source>
        <translation>从现在起为所选机器人规划；其他机器人保持不动</translation>
    </message>
    <message>
        <source>Choose the robot of the path first.</source>
        <translation>请先选择路径的机器人。</translation>
    </message>
    <message>
        <source>The path is being verified.</source>
        <translation>正在验证路径。</translation>
    </message>
    <message>
        <source>Select the robot that the file describes, and read it again.</source>
        <translation>请选择该文件所描述的机器人，然后重新读取。</translation>
    </message>
    <message>
        <source>%1 is a path of another robot</source>
        <translation>%1 是另一台机器人的路径</translation>
    </message>
    <message>
        <source>%1 is not in the plan any more</source>
        <translation>规划中已没有 %1</translation>
    </message>
    <message>
        <source>Nothing was done.</source>
        <translation>未执行任何操作。</translation>
    </message>
    <message>
        <source>%1 was not exported</source>
        <translation>%1 未导出</translation>
    </message>
    <message>
        <source>The path was changed since its export was asked for.</source>
        <translation>请求导出之后，该路径已被更改。</translation>
    </message>
    <message>
        <source>Export it again.</source>
        <translation>请重新导出。</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln leg(s) with unchanged ends, still proven free, were kept.</source>
        <translation>
            <numerusform>保留了 %Ln 段端点未变且仍证明无碰撞的路径。</numerusform>
        </translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>坐标系 %1</translation>
    </message>
    <message>
        <source>Work in no frame</source>
        <translation>不在任何坐标系中工作</translation>
    </message>
    <message>
        <source>Work in %1</source>
        <translation>在 %1 中工作</translation>
    </message>
    <message>
        <source>what carried it was removed</source>
        <translation>其载体已被移除</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>在 %1 上</translation>
    </message>
    <message>
        <source>for coordinates and programs</source>
        <translation>用于坐标和程序</translation>
    </message>
    <message>
        <source>%1; for coordinates and programs</source>
        <translation>%1；用于坐标和程序</translation>
    </message>
    <message>
        <source>Its places are in the frame %1.</source>
        <translation>其位置在坐标系 %1 中。</translation>
    </message>
    <message>
        <source>Store a &amp;frame here</source>
        <translation>在此存储坐标系(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Work in the frame</source>
        <translation>在坐标系中工作(&amp;W)</translation>
    </message>
    <message>
        <source>Store the current pose of the tool as a target; on the selected body, if any, or in the chosen frame, with which it moves</source>
        <translation>将工具的当前位姿存为目标；若选中了实体则放在其上，或放在所选坐标系中，并随之移动</translation>
    </message>
    <message>
        <source>Store the current pose of the tool as a frame for targets and programs; on the selected body, if any, with which it moves</source>
        <translation>将工具的当前位姿存为用于目标和程序的坐标系；若选中了实体则放在其上，并随之移动</translation>
    </message>
    <message>
        <source>Show coordinates of targets, and write programs, in the selected frame; once more: in none</source>
        <translation>在所选坐标系中显示目标坐标并编写程序；再次执行：不使用坐标系</translation>
    </message>
    <message>
        <source>Give the selected configuration, path, target or frame another name</source>
        <translation>为所选构型、路径、目标或坐标系重命名</translation>
    </message>
    <message>
        <source>Remove the selected configuration, path, place, target, frame or robot</source>
        <translation>移除所选构型、路径、位置、目标、坐标系或机器人</translation>
    </message>
    <message>
        <source>Select a frame in the list first.</source>
        <translation>请先在列表中选择一个坐标系。</translation>
    </message>
    <message>
        <source>Select a configuration, a path, a target or a frame first.</source>
        <translation>请先选择一个构型、路径、目标或坐标系。</translation>
    </message>
    <message>
        <source>Select a configuration, a path, a place, a target, a frame or a robot first.</source>
        <translation>请先选择一个构型、路径、位置、目标、坐标系或机器人。</translation>
    </message>
    <message>
        <source>Store %1 in %2</source>
        <translation>将 %1 存储到 %2</translation>
    </message>
    <message>
        <source>Its frames are in the cell now: %1.</source>
        <translation>其坐标系现已在单元中：%1。</translation>
    </message>
    <message>
        <source>It is in frames of the cell: %1.</source>
        <translation>它位于单元的坐标系中：%1。</translation>
    </message>
    <message>
        <source>There are too many frames in the cell for these: %1.</source>
        <translation>单元中的坐标系过多，无法添加：%1。</translation>
    </message>
    <message>
        <source>%1 was opened</source>
        <translation>已打开 %1</translation>
    </message>
    <message>
        <source>To write programs in one of its frames again, choose to work in it.</source>
        <translation>若要再次在其某个坐标系中编写程序，请选择在其中工作。</translation>
    </message>
    <message>
        <source>&amp;Allow pairs to touch…</source>
        <translation>允许成对接触(&amp;A)…</translation>
    </message>
    <message>
        <source>A comment of the program says so.</source>
        <translation>程序中的注释会说明这一点。</translation>
    </message>
    <message>
        <source>&amp;Declare the frame in RAPID programs</source>
        <translation>在 RAPID 程序中声明坐标系(&amp;D)</translation>
    </message>
    <message>
        <source>Allow &amp;pairs to touch…</source>
        <translation>允许成对接触(&amp;P)…</translation>
    </message>
    <message>
        <source>Write the data of the frame (wobjdata) into each RAPID program; two modules of one task must not both have them</source>
        <translation>将坐标系数据 (wobjdata) 写入每个 RAPID 程序；同一任务的两个模块不能都包含它们</translation>
    </message>
    <message>
        <source>Choose which of the pairs that meet here, or on the selected path, may touch; or no longer</source>
        <translation>选择此处或选中路径上相遇的哪些成对物体可以接触，或不再可以</translation>
    </message>
    <message>
        <source>Change the pairs that may touch</source>
        <translation>更改可接触的成对物体</translation>
    </message>
    <message>
        <source>&amp;Show the first on the time line</source>
        <translation>在时间线上显示第一个(&amp;S)</translation>
    </message>
    <message numerus="yes">
        <source>%Ln blend(s) became exact stops, as not every way within their zones is proven free.</source>
        <translation>
            <numerusform>%Ln 处圆滑过渡改为精确停止，因为其区域内并非每条路径都已证明无碰撞。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not checked, as they may touch: %1.</source>
        <translation>因允许接触而未检查：%1。</translation>
    </message>
    <message>
        <source>Replace the selected configuration, place, target or frame by the current position of the robot</source>
        <translation>用机器人的当前位置替换所选构型、位置、目标或坐标系</translation>
    </message>
    <message>
        <source>Select a configuration, a place of a path, a target or a frame first.</source>
        <translation>请先选择构型、路径位置、目标或坐标系。</translation>
    </message>
    <message>
        <source>%1 was removed</source>
        <translation>已删除 %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln path(s) keep its joint values: %1.</source>
        <translation>
            <numerusform>%Ln 条路径保留其关节值：%1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>撤销可恢复。</translation>
    </message>
    <message>
        <source>&amp;Let %1 touch %2</source>
        <translation>允许 %1 接触 %2(&amp;L)</translation>
    </message>
    <message>
        <source>Its curve turns to and fro again and again, as edges of scanned parts do: follow a section or a drawn curve, or set a larger tolerance.</source>
        <translation>该曲线像扫描零件的边缘那样反复来回转折：请沿截面或绘制的曲线走，或设置更大的公差。</translation>
    </message>
    <message>
        <source>&amp;Go to place %1</source>
        <translation>转到第 %1 点(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Go to %1</source>
        <translation>转到 %1(&amp;G)</translation>
    </message>
    <message numerus="yes">
        <source>%Ln blend(s) became smaller: a blend has half of the shorter motion beside it at most, and only where it is proven free.</source>
        <translation>
            <numerusform>%Ln 处过渡变小：过渡最多为相邻较短运动的一半，且仅在证明无碰撞处使用。</numerusform>
        </translation>
    </message>
    <message>
        <source>Write it without these lines</source>
        <translation>不写这些行</translation>
    </message>
    <message>
        <source>Write exact stops instead</source>
        <translation>改写为精确停止</translation>
    </message>
    <message numerus="yes">
        <source>%Ln blend(s) became exact stops, as %1 has none there; the program takes about %2 s.</source>
        <translation>
            <numerusform>%Ln 处过渡成为精确停止，因为 %1 在该处没有过渡；程序约需 %2 s。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln line(s) of the opened program, as outputs and waiting, were left out: the head of the program has their numbers.</source>
        <translation>
            <numerusform>已省略所打开程序的 %Ln 行，如输出和等待：程序开头列有其行号。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handwheel::CellReachOutline</name>
    <message>
        <source>Show the r&amp;each of the arm</source>
        <translation>显示机械臂的可达范围(&amp;E)</translation>
    </message>
    <message>
        <source>Show what the tool&apos;s centre point reaches within the joint limits, in the upright plane of the tool</source>
        <translation>在工具的竖直平面内，显示工具中心点在关节限位内的可达范围</translation>
    </message>
    <message>
        <source>Finding the reach of the arm</source>
        <translation>正在求机械臂的可达范围</translation>
    </message>
</context>
<context>
    <name>handwheel::CellRobots</name>
    <message>
        <source>Robot:</source>
        <translation>机器人：</translation>
    </message>
    <message>
        <source>Add a robot from a &amp;file…</source>
        <translation>从文件添加机器人(&amp;F)…</translation>
    </message>
    <message>
        <source>Add a bu&amp;ilt-in robot…</source>
        <translation>添加内置机器人(&amp;I)…</translation>
    </message>
    <message>
        <source>Remo&amp;ve the robot</source>
        <translation>移除机器人(&amp;V)</translation>
    </message>
    <message>
        <source>Add another robot to the cell, by its URDF or a table after Denavit and Hartenberg</source>
        <translation>用 URDF 或 Denavit-Hartenberg 表向单元再添加一个机器人</translation>
    </message>
    <message>
        <source>Add another robot to the cell from the library</source>
        <translation>从库中向单元再添加一个机器人</translation>
    </message>
    <message>
        <source>Open a robot cell first.</source>
        <translation>请先打开机器人单元。</translation>
    </message>
    <message>
        <source>It is the only robot of the cell.</source>
        <translation>它是单元中唯一的机器人。</translation>
    </message>
    <message>
        <source>Plan for %1</source>
        <translation>为 %1 规划</translation>
    </message>
    <message>
        <source>Remove the robot %1</source>
        <translation>移除机器人 %1</translation>
    </message>
    <message>
        <source>Add a robot</source>
        <translation>添加机器人</translation>
    </message>
    <message>
        <source>Robots (*.urdf *.dh.json);;All files (*)</source>
        <translation>机器人 (*.urdf *.dh.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>Add the robot %1</source>
        <translation>添加机器人 %1</translation>
    </message>
    <message>
        <source>%1 was removed</source>
        <translation>已移除 %1</translation>
    </message>
    <message>
        <source>Remove the selected robot, or else the one to plan for, with its configurations and paths</source>
        <translation>移除所选的机器人；未选时移除要规划的机器人，连同其位形和路径</translation>
    </message>
    <message>
        <source>Robot to plan for</source>
        <translation>要规划的机器人</translation>
    </message>
    <message>
        <source>The robot to plan for; the others stay where they are</source>
        <translation>要规划的机器人；其他机器人保持不动</translation>
    </message>
    <message>
        <source>%1 configurations and %2 paths were removed with it. Undo restores them.</source>
        <translation>一并移除了 %1 个位形和 %2 条路径。撤销可恢复。</translation>
    </message>
    <message>
        <source>The robots were not changed</source>
        <translation>机器人未更改</translation>
    </message>
</context>
<context>
    <name>handwheel::CellTargets</name>
    <message>
        <source>Searching configurations for the targets</source>
        <translation>正在搜索到达目标点的位形</translation>
    </message>
    <message>
        <source>its body was removed</source>
        <translation>其物体已被移除</translation>
    </message>
    <message>
        <source>its frame is on nothing</source>
        <translation>其坐标系没有载体</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>超出可达范围</translation>
    </message>
    <message numerus="yes">
        <source>%Ln configuration(s)</source>
        <translation>
            <numerusform>%Ln 个构型</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (on %2)</source>
        <translation>%1（在 %2 上）</translation>
    </message>
    <message>
        <source>%1 (in %2)</source>
        <translation>%1（在 %2 中）</translation>
    </message>
</context>
<context>
    <name>handwheel::ClayLayersView</name>
    <message>
        <source>La&amp;yers</source>
        <translation>图层(&amp;Y)</translation>
    </message>
    <message>
        <source>Sculpt in layers that can be weakened and turned off</source>
        <translation>在可减弱和关闭的图层中雕刻</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Layers, the topmost first</source>
        <translation>图层，最上层在前</translation>
    </message>
    <message>
        <source>Strength of the layer</source>
        <translation>图层强度</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add a layer on top</source>
        <translation>在顶部添加图层</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Take the layer and its strokes away</source>
        <translation>移除该图层及其笔画</translation>
    </message>
    <message>
        <source>Merge down</source>
        <translation>向下合并</translation>
    </message>
    <message>
        <source>Make the layer one with that below it, or with the volume, as it is visible now</source>
        <translation>将图层按当前可见状态与下方图层或体积合并</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>移除图层</translation>
    </message>
    <message>
        <source>Merge layer</source>
        <translation>合并图层</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Strokes change the volume itself.</source>
        <translation>笔画直接更改体积本身。</translation>
    </message>
    <message>
        <source>Strokes go on the top layer.</source>
        <translation>笔画作用于最上层。</translation>
    </message>
    <message>
        <source>The top layer takes no strokes while it is off or weaker than 100 %.</source>
        <translation>最上层关闭或强度低于 100 % 时不接受笔画。</translation>
    </message>
    <message>
        <source>Drilling and changes of the whole volume apply all layers.</source>
        <translation>钻孔和对整个体积的更改会应用所有图层。</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>添加图层</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>图层 %1</translation>
    </message>
    <message>
        <source>The layer stays as it is</source>
        <translation>图层保持不变</translation>
    </message>
    <message>
        <source>The top layer takes no strokes</source>
        <translation>最上层不接受笔画</translation>
    </message>
    <message>
        <source>“%1” is off, or its strength is below 100 %.</source>
        <translation>“%1”已关闭，或其强度低于 100 %。</translation>
    </message>
    <message>
        <source>Turn it on at full strength, or add a layer: the panel Layers has both.</source>
        <translation>请以全强度打开它或添加图层：“图层”面板中二者皆有。</translation>
    </message>
    <message>
        <source>Computing the layer</source>
        <translation>正在计算图层</translation>
    </message>
</context>
<context>
    <name>handwheel::ColourRow</name>
    <message>
        <source>Choose a colour…</source>
        <translation>选择颜色…</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>选择：%1</translation>
    </message>
</context>
<context>
    <name>handwheel::CommandModel</name>
    <message>
        <source>Not possible now</source>
        <translation>当前不可用</translation>
    </message>
</context>
<context>
    <name>handwheel::CommandPalette</name>
    <message>
        <source>&amp;Search commands…</source>
        <translation>搜索命令(&amp;S)…</translation>
    </message>
    <message>
        <source>Find and run any command by its name (Ctrl+K)</source>
        <translation>按名称查找并运行任意命令（Ctrl+K）</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>您想做什么？</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>搜索命令</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>找到的命令</translation>
    </message>
    <message>
        <source>No matching command.</source>
        <translation>没有匹配的命令。</translation>
    </message>
</context>
<context>
    <name>handwheel::ControlButton</name>
    <message>
        <source>Control</source>
        <translation>数控系统</translation>
    </message>
    <message>
        <source>Settings of the control that the program does not tell: decimal points and block skips</source>
        <translation>程序中未说明的数控系统设置：小数点和程序段跳过</translation>
    </message>
    <message>
        <source>A length without a decimal point counts 0.001 mm or 0.0001 inch</source>
        <translation>不带小数点的长度以 0.001 mm 或 0.0001 英寸为单位</translation>
    </message>
    <message>
        <source>Skip blocks with / or /1</source>
        <translation>跳过带 / 或 /1 的程序段</translation>
    </message>
    <message>
        <source>Skip blocks with /%1</source>
        <translation>跳过带 /%1 的程序段</translation>
    </message>
</context>
<context>
    <name>handwheel::CopyActions</name>
    <message>
        <source>Open a copy as %1</source>
        <translation>将副本作为%1打开</translation>
    </message>
    <message>
        <source>Open the surface of this document as a new document of that kind</source>
        <translation>将此文档的表面作为该类型的新文档打开</translation>
    </message>
    <message>
        <source>Copying %1</source>
        <translation>正在复制 %1</translation>
    </message>
    <message>
        <source>%1 was not copied</source>
        <translation>未能复制 %1</translation>
    </message>
</context>
<context>
    <name>handwheel::DefectActions</name>
    <message>
        <source>&amp;Cut and close</source>
        <translation>切开并封闭(&amp;C)</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>修复</translation>
    </message>
    <message>
        <source>&amp;Thicken sheets</source>
        <translation>加厚曲面(&amp;T)</translation>
    </message>
    <message>
        <source>Fix the defects selected in the list</source>
        <translation>修复列表中所选的缺陷</translation>
    </message>
    <message>
        <source>Close the hole across the part, and cut the part where the patch intersects it</source>
        <translation>跨零件封闭孔洞，并在补片与零件相交处切割零件</translation>
    </message>
    <message>
        <source>Reverse &amp;inside-out bodies</source>
        <translation>反转内外颠倒的体(&amp;I)</translation>
    </message>
    <message>
        <source>Resolve &amp;self-intersections</source>
        <translation>消除自相交(&amp;S)</translation>
    </message>
    <message>
        <source>Reverse all bodies whose triangles face inwards</source>
        <translation>反转所有三角形朝内的体</translation>
    </message>
    <message>
        <source>Cut all triangles that intersect apart, and join the rest</source>
        <translation>切开所有相交的三角形，并连接其余部分</translation>
    </message>
    <message>
        <source>Turn open sheets into thin closed bodies: the selected one, or all. A body grows to the side opposite to the normals; the triangles of the sheet stay where they are</source>
        <translation>将开放片体变成薄的封闭实体：所选片体或全部。实体向法线的反方向增长；片体的三角形保持原位</translation>
    </message>
    <message>
        <source>&amp;Thicken sheets by %1</source>
        <translation>加厚片体 %1(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Unite bodies</source>
        <translation>合并实体(&amp;U)</translation>
    </message>
    <message>
        <source>Make one body of those that intersect or lie inside each other, and remove what lies inside of it</source>
        <translation>将相交或彼此嵌套的体合为一个体，并移除其内部部分</translation>
    </message>
    <message>
        <source>Self-intersections are still being searched for.</source>
        <translation>仍在查找自相交。</translation>
    </message>
    <message>
        <source>There is no open sheet.</source>
        <translation>没有开放片体。</translation>
    </message>
    <message>
        <source>The selected hole is not the outer boundary of a sheet.</source>
        <translation>所选孔洞不是片体的外边界。</translation>
    </message>
    <message>
        <source>No body faces inwards.</source>
        <translation>没有朝内的体。</translation>
    </message>
    <message>
        <source>There are no self-intersections.</source>
        <translation>没有自相交。</translation>
    </message>
    <message>
        <source>No bodies intersect or lie inside each other.</source>
        <translation>没有相交或相互包含的体。</translation>
    </message>
</context>
<context>
    <name>handwheel::DefectCard</name>
    <message>
        <source>Remains: %1.</source>
        <translation>剩余：%1。</translation>
    </message>
</context>
<context>
    <name>handwheel::DefectList</name>
    <message numerus="yes">
        <source>%Ln edge(s), %1</source>
        <translation>
            <numerusform>%Ln 条边，%1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Area %1.</source>
        <translation>面积 %1。</translation>
    </message>
    <message>
        <source>%1 from the best-fitting plane (RMS).</source>
        <translation>与最佳拟合平面的偏差 %1（均方根）。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln island(s) inside: Repair all joins them to the patch, Fill alone covers them.</source>
        <translation>
            <numerusform>内有 %Ln 个岛：“全部修复”会把它们与补片相连，单独“填补”则会盖住它们。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handwheel::DefectModel</name>
    <message>
        <source>searching…</source>
        <translation>正在查找…</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1: searching</source>
        <translation>%1：正在查找</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Stayed open: %1.</source>
        <translation>未填补：%1。</translation>
    </message>
    <message>
        <source>Edge %1</source>
        <translation>边 %1</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>顶点 %1</translation>
    </message>
    <message>
        <source>Triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>Piece %1</source>
        <translation>碎片 %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln 个三角形</numerusform>
        </translation>
    </message>
    <message>
        <source>Pair %1</source>
        <translation>第 %1 对</translation>
    </message>
    <message>
        <source>Body %1</source>
        <translation>物体 %1</translation>
    </message>
    <message numerus="yes">
        <source>Here that is %Ln triangle(s), %1 % of all.</source>
        <translation>
            <numerusform>此处为 %Ln 个三角形，占全部的 %1 %。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2, before the repair %3</source>
        <translation>%1：%2，修复前 %3</translation>
    </message>
    <message>
        <source>Remains: %1.</source>
        <translation>仍存在：%1。</translation>
    </message>
    <message>
        <source>Last repair: %1.</source>
        <translation>上次修复：%1。</translation>
    </message>
    <message>
        <source>%1; remains: %2</source>
        <translation>%1；剩余：%2</translation>
    </message>
</context>
<context>
    <name>handwheel::DefectsPanel</name>
    <message>
        <source>Defects</source>
        <translation>缺陷</translation>
    </message>
    <message>
        <source>Open a mesh to see its holes and other defects here.</source>
        <translation>打开网格后，这里会显示其孔洞和其他缺陷。</translation>
    </message>
</context>
<context>
    <name>handwheel::DeviationPanel</name>
    <message>
        <source>Back to the defects</source>
        <translation>返回缺陷</translation>
    </message>
    <message>
        <source>Compare with another file…</source>
        <translation>与其他文件比较…</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>均方根</translation>
    </message>
    <message>
        <source>90 % within</source>
        <translation>90 % 以内</translation>
    </message>
    <message>
        <source>99 % within</source>
        <translation>99 % 以内</translation>
    </message>
    <message>
        <source>Colours up to</source>
        <translation>颜色范围</translation>
    </message>
    <message>
        <source>Under the pointer</source>
        <translation>指针处</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>保存报告…</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Deviation from the mesh as it was opened</source>
        <translation>与打开时网格的偏差</translation>
    </message>
    <message>
        <source>Deviation from %1</source>
        <translation>与 %1 的偏差</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Share of the area</source>
        <translation>面积占比</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Histogram of the deviation</source>
        <translation>偏差直方图</translation>
    </message>
    <message>
        <source>Zoom to this place</source>
        <translation>缩放到此处</translation>
    </message>
    <message>
        <source>Remove the colours</source>
        <translation>移除颜色</translation>
    </message>
</context>
<context>
    <name>handwheel::DeviationView</name>
    <message>
        <source>De&amp;viation…</source>
        <translation>偏差(&amp;V)…</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>正在比较…</translation>
    </message>
    <message>
        <source>Comparing %1</source>
        <translation>正在比较 %1</translation>
    </message>
    <message>
        <source>Compared %1: largest distance %2 mm</source>
        <translation>已比较 %1：最大距离 %2 mm</translation>
    </message>
    <message>
        <source>The meshes could not be compared</source>
        <translation>无法比较网格</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比较对象</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Report (*.pdf *.html *.json)</source>
        <translation>报告 (*.pdf *.html *.json)</translation>
    </message>
    <message>
        <source>as it was opened</source>
        <translation>打开时</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>正在保存 %1</translation>
    </message>
    <message>
        <source>Saved the report %1</source>
        <translation>已保存报告 %1</translation>
    </message>
    <message>
        <source>%1 has no pictures</source>
        <translation>%1 没有图片</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>无法保存 %1</translation>
    </message>
    <message>
        <source>Show the deviation of the mesh from the opened file in colours</source>
        <translation>用颜色显示网格与所打开文件的偏差</translation>
    </message>
</context>
<context>
    <name>handwheel::DeviceCard</name>
    <message>
        <source>No device in use</source>
        <translation>没有使用设备</translation>
    </message>
    <message>
        <source>The pointer is outside the view</source>
        <translation>指针在视图之外</translation>
    </message>
    <message>
        <source>Plug one in: it appears here by itself.</source>
        <translation>接上设备后会自动出现在这里。</translation>
    </message>
    <message>
        <source>Choose one from the list above.</source>
        <translation>请从上面的列表中选择。</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>无设备</translation>
    </message>
    <message>
        <source>Look for devices again</source>
        <translation>重新查找设备</translation>
    </message>
    <message>
        <source>Not in real time: what to do</source>
        <translation>非实时：怎么办</translation>
    </message>
    <message>
        <source>%1 (unplugged)</source>
        <translation>%1（已拔下）</translation>
    </message>
    <message>
        <source>Simulates at the mouse pointer what a device would feel. The mouse also points and rotates the view without this.</source>
        <translation>在鼠标指针处模拟设备所感受到的力。不使用此功能时，鼠标同样可以指点和旋转视图。</translation>
    </message>
    <message>
        <source>%1 moves the view. Choose it above only if it is to move the tip.</source>
        <translation>%1 用于移动视图。仅当要用它移动尖端时才在上方选择它。</translation>
    </message>
    <message>
        <source>Ticks are late when the computer is busy, and the stiffness is reduced to allow for that</source>
        <translation>计算机繁忙时节拍会延迟，因此降低了刚度</translation>
    </message>
</context>
<context>
    <name>handwheel::DeviceFinder</name>
    <message>
        <source>Looking for devices</source>
        <translation>正在查找设备</translation>
    </message>
</context>
<context>
    <name>handwheel::DevicePanel</name>
    <message>
        <source>No device is in use.</source>
        <translation>没有使用设备。</translation>
    </message>
    <message>
        <source>About the device</source>
        <translation>关于设备</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>映射</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>时序</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Safety: the force is not limited.</source>
        <translation>安全：力未受限制。</translation>
    </message>
</context>
<context>
    <name>handwheel::DimensionsView</name>
    <message>
        <source>Dimensions in the &amp;view</source>
        <translation>在视图中显示尺寸(&amp;V)</translation>
    </message>
    <message>
        <source>Show diameters, lengths, radii and chamfers of the part in the view</source>
        <translation>在视图中显示零件的直径、长度、半径和倒角</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
</context>
<context>
    <name>handwheel::DockTitle</name>
    <message>
        <source>Dock this panel</source>
        <translation>停靠此面板</translation>
    </message>
    <message>
        <source>Undock this panel</source>
        <translation>取消停靠此面板</translation>
    </message>
    <message>
        <source>Dock the panel “%1”</source>
        <translation>停靠面板“%1”</translation>
    </message>
    <message>
        <source>Undock the panel “%1”</source>
        <translation>取消停靠面板“%1”</translation>
    </message>
    <message>
        <source>Hide this panel</source>
        <translation>隐藏此面板</translation>
    </message>
    <message>
        <source>Hide the panel “%1”</source>
        <translation>隐藏面板“%1”</translation>
    </message>
</context>
<context>
    <name>handwheel::Document</name>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>更改 %2 的%1</translation>
    </message>
</context>
<context>
    <name>handwheel::DocumentTabs</name>
    <message>
        <source>Open documents</source>
        <translation>已打开的文档</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>关闭 %1</translation>
    </message>
</context>
<context>
    <name>handwheel::DocumentsPanel</name>
    <message>
        <source>Open documents</source>
        <translation>已打开的文档</translation>
    </message>
    <message>
        <source>Hide the surface</source>
        <translation>隐藏表面</translation>
    </message>
    <message>
        <source>Show the surface</source>
        <translation>显示表面</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <translation>%1，未保存</translation>
    </message>
    <message>
        <source>%1, hidden</source>
        <translation>%1，已隐藏</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Hide or show the d&amp;ocument</source>
        <translation>隐藏或显示文档(&amp;O)</translation>
    </message>
</context>
<context>
    <name>handwheel::DrillView</name>
    <message>
        <source>Breakthrough: stop. %1 mm beyond</source>
        <translation>已钻穿：请停止。超出 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm beside the planned path</source>
        <translation>偏离规划路径 %1 mm</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>钻孔</translation>
    </message>
    <message>
        <source>Drilling…</source>
        <translation>正在钻孔…</translation>
    </message>
    <message>
        <source>%1 mm deep, %2 N, %3 N·mm, +%4 K (estimate)</source>
        <translation>深 %1 mm，%2 N，%3 N·mm，+%4 K（估计值）</translation>
    </message>
    <message>
        <source>The drill entered the forbidden region.</source>
        <translation>钻头进入了禁区。</translation>
    </message>
    <message>
        <source>Beside the planned path</source>
        <translation>偏离规划路径</translation>
    </message>
    <message>
        <source>The drill is more than %1 mm away from it.</source>
        <translation>钻头偏离规划路径超过 %1 mm。</translation>
    </message>
    <message>
        <source>Breakthrough</source>
        <translation>钻穿</translation>
    </message>
    <message>
        <source>The drill is through after %1 s.</source>
        <translation>钻头在 %1 s 后钻穿。</translation>
    </message>
    <message>
        <source>The forbidden region was entered by %1 mm: this attempt has failed</source>
        <translation>已进入禁区 %1 mm：本次尝试失败</translation>
    </message>
    <message>
        <source>The attempt has failed</source>
        <translation>本次尝试失败</translation>
    </message>
    <message>
        <source>Release the button, undo the hole, and begin where the green rod meets the surface.</source>
        <translation>请松开按键，撤销该孔，然后从绿色细杆与表面相交处开始。</translation>
    </message>
    <message>
        <source>Release the button now: each further millimetre counts.</source>
        <translation>请立即松开按键：每多一毫米都会计入。</translation>
    </message>
    <message>
        <source>Hold the button on the part to drill</source>
        <translation>在零件上按住按钮即可钻孔</translation>
    </message>
    <message>
        <source>Breakthrough, %1 mm beyond</source>
        <translation>已钻穿，超出 %1 mm</translation>
    </message>
    <message>
        <source>Undo the hole to try again, and stop at the breakthrough. The report lists this try.</source>
        <translation>撤销此孔即可再试，并在钻穿时停止。报告会列出这次尝试。</translation>
    </message>
</context>
<context>
    <name>handwheel::ExerciseEditor</name>
    <message>
        <source>Add what is marked</source>
        <translation>添加要评分的内容</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>添加步骤</translation>
    </message>
    <message>
        <source>Remove a criterion</source>
        <translation>移除评分项</translation>
    </message>
    <message>
        <source>Remove a step</source>
        <translation>移除步骤</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>评分项</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Add a criterion</source>
        <translation>添加评分项</translation>
    </message>
    <message>
        <source>Move a criterion</source>
        <translation>移动评分项</translation>
    </message>
    <message>
        <source>Move a step</source>
        <translation>移动步骤</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Remove the selected row</source>
        <translation>移除所选行</translation>
    </message>
    <message>
        <source>Move the selected row up</source>
        <translation>上移所选行</translation>
    </message>
    <message>
        <source>Move the selected row down</source>
        <translation>下移所选行</translation>
    </message>
    <message>
        <source>Choose the criteria of a step</source>
        <translation>选择步骤的评分项</translation>
    </message>
    <message>
        <source>New hint</source>
        <translation>新提示</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 分</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message numerus="yes">
        <source>Add %Ln size(s) of the target</source>
        <translation>
            <numerusform>添加目标的 %Ln 个尺寸</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %Ln size(s) of the target</source>
        <translation>
            <numerusform>目标的全部 %Ln 个尺寸</numerusform>
        </translation>
    </message>
    <message>
        <source>A size of the target</source>
        <translation>目标的一个尺寸</translation>
    </message>
    <message>
        <source>Add a hint</source>
        <translation>添加提示</translation>
    </message>
    <message>
        <source>Change a hint</source>
        <translation>更改提示</translation>
    </message>
    <message>
        <source>Remove a hint</source>
        <translation>移除提示</translation>
    </message>
    <message>
        <source>Points: %1</source>
        <translation>分数：%1</translation>
    </message>
</context>
<context>
    <name>handwheel::ExerciseLesson</name>
    <message>
        <source>&amp;Begin</source>
        <translation>开始(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Hand in…</source>
        <translation>提交(&amp;H)…</translation>
    </message>
    <message>
        <source>Measure the sizes of the drawing on the part as it is now</source>
        <translation>在零件当前状态下测量图纸尺寸</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>您的姓名</translation>
    </message>
    <message>
        <source>: %1 … %2%3</source>
        <translation>：%1 … %2%3</translation>
    </message>
    <message>
        <source>: at most %1%2</source>
        <translation>：最大 %1%2</translation>
    </message>
    <message>
        <source>: at least %1%2</source>
        <translation>：最小 %1%2</translation>
    </message>
    <message>
        <source>Save a file for the teacher, with the part and all of its passes</source>
        <translation>保存提交给教师的文件，包含零件及其所有走刀</translation>
    </message>
    <message>
        <source>Write your name above first</source>
        <translation>请先在上方填写您的姓名</translation>
    </message>
    <message>
        <source>between the faces at Z %1 mm and Z %2 mm</source>
        <translation>在 Z %1 mm 与 Z %2 mm 的端面之间</translation>
    </message>
    <message>
        <source>The work was changed since; measured before that:</source>
        <translation>作业此后已更改；此前的测量结果：</translation>
    </message>
</context>
<context>
    <name>handwheel::ExerciseUi</name>
    <message>
        <source>&amp;Begin</source>
        <translation>开始(&amp;B)</translation>
    </message>
    <message>
        <source>Open the stock and work on the exercise, step by step</source>
        <translation>打开毛坯，逐步完成练习</translation>
    </message>
    <message>
        <source>&amp;Student&apos;s copy</source>
        <translation>学生副本(&amp;S)</translation>
    </message>
    <message>
        <source>Open the exercise as students see it; save it for them</source>
        <translation>按学生看到的样子打开练习；可保存后发给学生</translation>
    </message>
    <message>
        <source>Take as model s&amp;olution</source>
        <translation>设为参考答案(&amp;O)</translation>
    </message>
    <message>
        <source>Take as &amp;target</source>
        <translation>设为目标(&amp;T)</translation>
    </message>
    <message>
        <source>Make the shape of that work the target of the exercise</source>
        <translation>将该作业的形状作为练习的目标</translation>
    </message>
    <message>
        <source>&amp;Mark…</source>
        <translation>评分(&amp;M)…</translation>
    </message>
    <message>
        <source>Mark files that students have handed in</source>
        <translation>对学生提交的文件评分</translation>
    </message>
    <message>
        <source>New e&amp;xercise</source>
        <translation>新建练习(&amp;X)</translation>
    </message>
    <message>
        <source>Prepare an exercise for students</source>
        <translation>为学生准备练习</translation>
    </message>
    <message>
        <source>First &amp;lesson at the lathe</source>
        <translation>车床第一课(&amp;L)</translation>
    </message>
    <message>
        <source>Turn your first shoulder</source>
        <translation>车削您的第一个台阶</translation>
    </message>
    <message>
        <source>Exercise: shaft with shoulders</source>
        <translation>练习：台阶轴</translation>
    </message>
    <message>
        <source>Exercise: bored bush</source>
        <translation>练习：镗孔衬套</translation>
    </message>
    <message>
        <source>Exercise: ball</source>
        <translation>练习：球</translation>
    </message>
    <message>
        <source>Exercise: gourd</source>
        <translation>练习：葫芦</translation>
    </message>
    <message>
        <source>Exercise: dumb-bell weight</source>
        <translation>练习：哑铃</translation>
    </message>
    <message>
        <source>Exercise: wine glass</source>
        <translation>练习：酒杯</translation>
    </message>
    <message>
        <source>Open a prepared exercise</source>
        <translation>打开准备好的练习</translation>
    </message>
    <message>
        <source>Handed in by %1</source>
        <translation>由 %1 提交</translation>
    </message>
    <message>
        <source>The teacher marks it with the exercise.</source>
        <translation>教师用该练习对其评分。</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n 个步骤</numerusform>
        </translation>
    </message>
    <message>
        <source>New exercise</source>
        <translation>新建练习</translation>
    </message>
    <message>
        <source>Opened %1: exercise “%2”</source>
        <translation>已打开 %1：练习“%2”</translation>
    </message>
    <message>
        <source>Take the model solution</source>
        <translation>采用参考答案</translation>
    </message>
    <message>
        <source>The target was not taken</source>
        <translation>未采用目标</translation>
    </message>
    <message>
        <source>Take the target</source>
        <translation>采用目标</translation>
    </message>
    <message>
        <source>Mark what was handed in</source>
        <translation>对提交的作业评分</translation>
    </message>
    <message>
        <source>Submissions (%1)</source>
        <translation>提交的作业 (%1)</translation>
    </message>
    <message>
        <source>Marking</source>
        <translation>正在评分</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>无法保存 %1</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>表格 (%1)</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Report (%1)</source>
        <translation>报告 (%1)</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>E&amp;xercise</source>
        <translation>练习(&amp;X)</translation>
    </message>
    <message>
        <source>Exercise: thread M20</source>
        <translation>练习：螺纹 M20</translation>
    </message>
    <message>
        <source>Exercise: first shoulder</source>
        <translation>练习：第一个台阶</translation>
    </message>
    <message>
        <source>The model solution was not taken</source>
        <translation>未采用参考答案</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>正在写入 %1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>&amp;Round the target…</source>
        <translation>圆整目标(&amp;R)…</translation>
    </message>
    <message>
        <source>Give the target round sizes and sharp corners, as a drawing has them</source>
        <translation>使目标具有圆整尺寸和尖角，如图纸所示</translation>
    </message>
    <message>
        <source>Taking the target</source>
        <translation>正在采用目标</translation>
    </message>
    <message>
        <source>Round the target</source>
        <translation>圆整目标</translation>
    </message>
    <message>
        <source>Op&amp;en the model solution</source>
        <translation>打开参考答案(&amp;E)</translation>
    </message>
    <message>
        <source>Open a copy of the model solution, to look at it or to go on from it</source>
        <translation>打开参考答案的副本，以便查看或在其基础上继续</translation>
    </message>
    <message>
        <source>Model solution taken</source>
        <translation>已采用参考答案</translation>
    </message>
    <message numerus="yes">
        <source>The work in “%1”, as it is after %n step(s) of its history, is the model solution now.</source>
        <translation>
            <numerusform>“%1”中的作业（其历史记录的 %n 个步骤之后的状态）现为参考答案。</numerusform>
        </translation>
    </message>
    <message>
        <source>“Open the model solution” shows it. Students do not get it.</source>
        <translation>用“打开参考答案”可查看。学生得不到它。</translation>
    </message>
    <message>
        <source>It is in the folder %1.</source>
        <translation>它位于文件夹 %1 中。</translation>
    </message>
    <message>
        <source>%1, class</source>
        <translation>%1，班级</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>保存对照报告</translation>
    </message>
    <message>
        <source>%1, report</source>
        <translation>%1，报告</translation>
    </message>
    <message>
        <source>%1, comparison</source>
        <translation>%1，对照</translation>
    </message>
    <message>
        <source>A lesson of about five minutes: the program says what to do, and measures the part.</source>
        <translation>约五分钟的课程：程序告诉您该做什么，并测量零件。</translation>
    </message>
    <message>
        <source>&amp;Import target…</source>
        <translation>导入目标(&amp;I)…</translation>
    </message>
    <message>
        <source>Import a target</source>
        <translation>导入目标</translation>
    </message>
    <message>
        <source>Turned parts (%1)</source>
        <translation>车削件 (%1)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>%1 was not taken as the target</source>
        <translation>未将 %1 采用为目标</translation>
    </message>
    <message>
        <source>Import target</source>
        <translation>导入目标</translation>
    </message>
    <message>
        <source>Target read from %1</source>
        <translation>已从 %1 读取目标</translation>
    </message>
    <message>
        <source>%1 is the target now</source>
        <translation>%1 现为目标</translation>
    </message>
    <message>
        <source>Exercise: burr hole in the skull</source>
        <translation>练习：颅骨钻孔</translation>
    </message>
    <message>
        <source>Where the target lies</source>
        <translation>目标的位置</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>导入(&amp;I)</translation>
    </message>
    <message>
        <source>The exercise was changed meanwhile.</source>
        <translation>练习在此期间已被更改。</translation>
    </message>
    <message>
        <source>Import the target again.</source>
        <translation>请重新导入目标。</translation>
    </message>
    <message>
        <source>Keep the work that was started from this exercise as its model solution</source>
        <translation>将从此练习开始的作业保留为其参考答案</translation>
    </message>
    <message>
        <source>Import the shape that students are to make, from DXF, SVG, STEP, a mesh or a workpiece</source>
        <translation>从 DXF、SVG、STEP、网格或工件导入学生要加工的形状</translation>
    </message>
    <message>
        <source>Turn a shoulder step by step; no experience is needed</source>
        <translation>逐步车削一个台阶；无需经验</translation>
    </message>
    <message>
        <source>New exercise: %1</source>
        <translation>新建练习：%1</translation>
    </message>
    <message>
        <source>Drill a burr hole</source>
        <translation>颅骨钻孔</translation>
    </message>
    <message>
        <source>Opens an exercise on a skull: drill along the rod, and stop at the breakthrough.</source>
        <translation>打开一个颅骨练习：沿细杆钻孔，并在钻穿时停止。</translation>
    </message>
    <message>
        <source>Points: %1. Students get a copy without the answers.</source>
        <translation>分数：%1。学生得到不含答案的副本。</translation>
    </message>
    <message>
        <source>%1: %2 of %3.</source>
        <translation>%1：%2 分（满分 %3 分）。</translation>
    </message>
    <message>
        <source>From %1 to %2 of %3.</source>
        <translation>%1 至 %2 分（满分 %3 分）。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln file(s) could not be marked; the table says why.</source>
        <translation>
            <numerusform>%Ln 个文件无法评分；原因见表格。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln work(s) marked</source>
        <translation>
            <numerusform>已对 %Ln 份作业评分</numerusform>
        </translation>
    </message>
    <message>
        <source>“Task” shows where it lies in the bar, “Criteria” what is measured.</source>
        <translation>“任务”显示它在棒料中的位置，“评分项”显示测量的项目。</translation>
    </message>
    <message>
        <source>Model solution</source>
        <translation>参考解</translation>
    </message>
    <message>
        <source>Model solution of %1</source>
        <translation>%1 的参考解</translation>
    </message>
    <message>
        <source>Turn the target en&amp;d for end</source>
        <translation>将目标首尾调转(&amp;D)</translation>
    </message>
    <message>
        <source>Make the end at the chuck the free one, whose face is finished</source>
        <translation>将卡盘端变为自由端，其端面需加工</translation>
    </message>
    <message>
        <source>student&apos;s copy</source>
        <translation>学生副本</translation>
    </message>
    <message>
        <source>Student&apos;s copy</source>
        <translation>学生副本</translation>
    </message>
    <message>
        <source>%1, student&apos;s copy</source>
        <translation>%1，学生副本</translation>
    </message>
    <message>
        <source>The target was not turned</source>
        <translation>目标未调转</translation>
    </message>
    <message>
        <source>Turn the target end for end</source>
        <translation>将目标首尾调转</translation>
    </message>
    <message>
        <source>The target lies the other way round now</source>
        <translation>目标现已调转</translation>
    </message>
    <message>
        <source>“Criteria” are measured at the places where they were: look at them.</source>
        <translation>“评分标准”仍在原来的位置测量：请检查。</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>Remove from the class</source>
        <translation>从班级中移除</translation>
    </message>
    <message>
        <source>Parts to be drilled (%1)</source>
        <translation>待钻零件 (%1)</translation>
    </message>
    <message>
        <source>“Task” has the planned path and the forbidden region, “Criteria” what is measured.</source>
        <translation>“任务”中是规划路径和禁区，“评分项”中是测量内容。</translation>
    </message>
    <message>
        <source>Open an exercise first.</source>
        <translation>请先打开一个练习。</translation>
    </message>
    <message>
        <source>This is a student&apos;s copy.</source>
        <translation>这是学生副本。</translation>
    </message>
    <message>
        <source>No work on this exercise is open.</source>
        <translation>没有打开此练习的作业。</translation>
    </message>
    <message>
        <source>The exercise has no solution.</source>
        <translation>该练习没有参考答案。</translation>
    </message>
    <message>
        <source>The exercise has no target.</source>
        <translation>该练习没有目标。</translation>
    </message>
    <message>
        <source>It is for targets of turned parts only.</source>
        <translation>仅适用于车削件的目标。</translation>
    </message>
    <message>
        <source>The exercise has another target now</source>
        <translation>练习现在有了另一个目标</translation>
    </message>
</context>
<context>
    <name>handwheel::FidelityPanel</name>
    <message>
        <source>Measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>now</source>
        <translation>当前</translation>
    </message>
</context>
<context>
    <name>handwheel::FileActions</name>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>Open files</source>
        <translation>打开文件</translation>
    </message>
    <message>
        <source>Save this document</source>
        <translation>保存此文档</translation>
    </message>
    <message>
        <source>Save this document under another name</source>
        <translation>以其他名称保存此文档</translation>
    </message>
    <message>
        <source>Close this document</source>
        <translation>关闭此文档</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>清空列表(&amp;C)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>另存为</translation>
    </message>
    <message>
        <source>Save in:</source>
        <translation>保存到：</translation>
    </message>
    <message>
        <source>Ne&amp;xt document</source>
        <translation>下一个文档(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Previous document</source>
        <translation>上一个文档(&amp;P)</translation>
    </message>
    <message>
        <source>Go to the next open document</source>
        <translation>转到下一个打开的文档</translation>
    </message>
    <message>
        <source>Go to the previous open document</source>
        <translation>转到上一个打开的文档</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Save as *%1…</source>
        <translation>另存为 *%1…</translation>
    </message>
    <message>
        <source>Open beside %1</source>
        <translation>在 %1 旁打开</translation>
    </message>
</context>
<context>
    <name>handwheel::FileLoader</name>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>正在恢复 %1</translation>
    </message>
    <message>
        <source>Recovered %1 as it was last autosaved</source>
        <translation>已将 %1 恢复到最近一次自动保存的状态</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>无法打开 %1</translation>
    </message>
    <message>
        <source>Open what is readable</source>
        <translation>打开可读部分</translation>
    </message>
    <message>
        <source>…and %1 more, listed in the Log.</source>
        <translation>…还有 %1 项，见日志。</translation>
    </message>
    <message>
        <source>Not kept by Handwheel: %1.</source>
        <translation>Handwheel 未保留：%1。</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 已损坏</translation>
    </message>
    <message>
        <source>%1 is opened for reading only</source>
        <translation>%1 以只读方式打开</translation>
    </message>
    <message>
        <source>“Save” will ask for a new name, so the original stays as it is.</source>
        <translation>“保存”时会要求新文件名，原文件保持不变。</translation>
    </message>
    <message>
        <source>Recovering</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Nothing of %1 can be read</source>
        <translation>无法读取 %1 中的任何内容</translation>
    </message>
    <message>
        <source>%1 is opened as a mesh</source>
        <translation>%1 按网格打开</translation>
    </message>
    <message numerus="yes">
        <source>%Ln more place(s) are damaged</source>
        <translation>
            <numerusform>另有 %Ln 处损坏</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is incomplete</source>
        <translation>%1 不完整</translation>
    </message>
    <message>
        <source>Notes on %1</source>
        <translation>关于 %1 的说明</translation>
    </message>
    <message>
        <source>It was written by a newer version of Handwheel; contents that this version does not know are not shown.</source>
        <translation>此文件由较新版本的 Handwheel 写入；本版本不认识的内容不会显示。</translation>
    </message>
    <message>
        <source>Not all of %1 is kept</source>
        <translation>%1 的内容未全部保留</translation>
    </message>
    <message>
        <source>A document could not be recovered</source>
        <translation>无法恢复某个文档</translation>
    </message>
    <message>
        <source>%1 could not be recovered</source>
        <translation>无法恢复 %1</translation>
    </message>
    <message>
        <source>Its autosave is kept, and offered again at the next start.</source>
        <translation>其自动保存会保留，并在下次启动时再次提示。</translation>
    </message>
    <message>
        <source>The last changes of %1 cannot be read</source>
        <translation>无法读取 %1 的最近更改</translation>
    </message>
    <message>
        <source>It is recovered as it was autosaved before them.</source>
        <translation>将恢复到这些更改之前自动保存的状态。</translation>
    </message>
    <message>
        <source>Their file is kept and listed in the Log; it can be discarded at the next start.</source>
        <translation>这些更改的文件会保留，并在日志中列出；下次启动时可将其丢弃。</translation>
    </message>
    <message>
        <source>When it was opened, its file had contents that were damaged or that Handwheel does not keep. They are still in that file.</source>
        <translation>打开时，该文件含有已损坏或 Handwheel 不保留的内容。这些内容仍在原文件中。</translation>
    </message>
    <message>
        <source>Save it to keep it.</source>
        <translation>保存后才会保留。</translation>
    </message>
</context>
<context>
    <name>handwheel::FileSaver</name>
    <message>
        <source>Saving %1</source>
        <translation>正在保存 %1</translation>
    </message>
    <message>
        <source>Saved %1: %2 bytes, read back and compared</source>
        <translation>已保存 %1：%2 字节，已回读比对</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>无法保存 %1</translation>
    </message>
    <message>
        <source>%1 was written</source>
        <translation>%1 已写入</translation>
    </message>
    <message>
        <source>The display unit is not in this file.</source>
        <translation>显示单位未写入此文件。</translation>
    </message>
    <message>
        <source>Saving %1 was cancelled</source>
        <translation>已取消保存 %1</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>重新保存</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>%1 contains the state before your last change</source>
        <translation>%1 保存的是您最后一次更改之前的状态</translation>
    </message>
    <message>
        <source>%1 does not contain the whole document</source>
        <translation>%1 未包含文档的全部内容</translation>
    </message>
    <message>
        <source>The document stays open. Save it as *%1, too, to keep all of it.</source>
        <translation>文档保持打开。请同时另存为 *%1，以保留全部内容。</translation>
    </message>
    <message>
        <source>The file does not contain the whole document, which is not saved yet.</source>
        <translation>该文件不包含整个文档；文档尚未保存。</translation>
    </message>
    <message>
        <source>Save the document as *%1 to continue with it later.</source>
        <translation>请将文档另存为 *%1，以便以后继续处理。</translation>
    </message>
    <message>
        <source>Nothing was written: the file is unchanged.</source>
        <translation>没有写入任何内容：文件未更改。</translation>
    </message>
    <message>
        <source>The document is still open, with all its changes.</source>
        <translation>文档仍然打开，所有更改都在。</translation>
    </message>
</context>
<context>
    <name>handwheel::FixPreview</name>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Computing the preview…</source>
        <translation>正在计算预览…</translation>
    </message>
    <message>
        <source>Nothing would change: %1.</source>
        <translation>不会有任何变化：%1。</translation>
    </message>
    <message>
        <source>Nothing would change.</source>
        <translation>不会有任何变化。</translation>
    </message>
    <message numerus="yes">
        <source>Removes %Ln triangle(s).</source>
        <translation>
            <numerusform>移除 %Ln 个三角形。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Adds %Ln triangle(s).</source>
        <translation>
            <numerusform>添加 %Ln 个三角形。</numerusform>
        </translation>
    </message>
    <message>
        <source>Replaces %1 by %2.</source>
        <translation>将 %1 替换为 %2。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln 个三角形</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handwheel::FoldButton</name>
    <message>
        <source>Hide the fields of %1</source>
        <translation>隐藏 %1 的字段</translation>
    </message>
    <message>
        <source>Show the fields of %1</source>
        <translation>显示 %1 的字段</translation>
    </message>
</context>
<context>
    <name>handwheel::ForcePlot</name>
    <message>
        <source>Force of the last seconds</source>
        <translation>最近几秒的力</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>要求的</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>发送的</translation>
    </message>
</context>
<context>
    <name>handwheel::FrameTiming</name>
    <message>
        <source>Display frame in use: %1 of %2 ms (%3 %)</source>
        <translation>显示帧用时：%2 毫秒中的 %1 毫秒（%3 %）</translation>
    </message>
    <message>
        <source>Predicted in addition, after an edit: %1 ms (%2 %)</source>
        <translation>另外预测编辑之后：%1 毫秒（%2 %）</translation>
    </message>
</context>
<context>
    <name>handwheel::HandwheelDial</name>
    <message>
        <source>Handwheel</source>
        <translation>手轮</translation>
    </message>
    <message>
        <source>Drag around the centre, or use the wheel or arrow keys: one division (Shift: ten, Ctrl: a tenth); Page Up and Down: one turn; Home or double click: set the dial to zero</source>
        <translation>绕中心拖动，或使用滚轮或方向键：一格（Shift：十格，Ctrl：十分之一格）；Page Up 和 Page Down：一圈；Home 或双击：刻度盘归零</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 div</source>
        <translation>%1 格</translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s)</source>
        <translation>
            <numerusform>%n 圈</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handwheel::HapticSession</name>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>Closing %1</source>
        <translation>正在关闭 %1</translation>
    </message>
</context>
<context>
    <name>handwheel::HistogramView</name>
    <message>
        <source>Histogram with the range of values</source>
        <translation>直方图和值的范围</translation>
    </message>
    <message>
        <source>Number of samples of each value (logarithmic). Drag the handles: the values between them are the segment.</source>
        <translation>各个值的采样点数（对数）。拖动控制柄：其间的值即为分割区域。</translation>
    </message>
</context>
<context>
    <name>handwheel::HolePreview</name>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Comparing methods</source>
        <translation>正在比较方法</translation>
    </message>
</context>
<context>
    <name>handwheel::HoleSettings</name>
    <message>
        <source>Fill method</source>
        <translation>填补方法</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Computing the patch…</source>
        <translation>正在计算补片…</translation>
    </message>
    <message>
        <source>Cannot be filled: %1.</source>
        <translation>无法填补：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln new triangle(s)</source>
        <translation>
            <numerusform>%Ln 个新三角形</numerusform>
        </translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Show the result of each method for this hole</source>
        <translation>显示每种方法对此孔洞的结果</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Thickness of the sheet&apos;s thin body, which grows to the side opposite to the normals: the triangles of the sheet stay where they are. Less where that would intersect anything; the log says what was reached.</source>
        <translation>片体薄实体的厚度，向法线的反方向增长：片体的三角形保持原位。会与其他部分相交处则更薄；日志说明达到的厚度。</translation>
    </message>
    <message>
        <source>Check the patch: %1.</source>
        <translation>请检查补片：%1。</translation>
    </message>
</context>
<context>
    <name>handwheel::InstructionEditor</name>
    <message>
        <source>Done when these criteria are met:</source>
        <translation>达到以下评分项时完成：</translation>
    </message>
    <message>
        <source>Hints, shown one after another; double-click to change one:</source>
        <translation>提示，依次显示；双击可更改：</translation>
    </message>
    <message>
        <source>Add a hint</source>
        <translation>添加提示</translation>
    </message>
    <message>
        <source>Remove the hint</source>
        <translation>移除提示</translation>
    </message>
</context>
<context>
    <name>handwheel::JobBar</name>
    <message>
        <source>Cancel this job</source>
        <translation>取消此任务</translation>
    </message>
    <message>
        <source>Cancel “%1”</source>
        <translation>取消“%1”</translation>
    </message>
    <message>
        <source>Show all jobs</source>
        <translation>显示所有任务</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>+%1</source>
        <translation>+%1</translation>
    </message>
    <message numerus="yes">
        <source>%n more job(s)</source>
        <translation>
            <numerusform>另有 %n 个任务</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (waiting)</source>
        <translation>%1（等待中）</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>已用 %1</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
</context>
<context>
    <name>handwheel::KindUi</name>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>Measure distances, angles and walls</source>
        <translation>测量距离、角度和壁厚</translation>
    </message>
    <message>
        <source>&amp;Drill</source>
        <translation>钻孔(&amp;D)</translation>
    </message>
    <message>
        <source>Drill into the part, with thrust and torque</source>
        <translation>在零件上钻孔，带轴向力和扭矩</translation>
    </message>
</context>
<context>
    <name>handwheel::LatheEvents</name>
    <message>
        <source>%1 s: crash, %2 – %3 at R %4, Z %5. %6</source>
        <translation>%1 s：碰撞，%2 – %3，位于 R %4、Z %5。%6</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s：%2</translation>
    </message>
    <message>
        <source>Crashes and warnings</source>
        <translation>碰撞与警告</translation>
    </message>
    <message>
        <source>Power: the cut needs %1 kW, and the motor has %2 kW; the spindle slows down.</source>
        <translation>功率：切削需要 %1 kW，而电机只有 %2 kW；主轴减速。</translation>
    </message>
    <message>
        <source>Torque: the cut needs %1 N·m, and the spindle has %2 N·m; the spindle stalls.</source>
        <translation>扭矩：切削需要 %1 N·m，而主轴只有 %2 N·m；主轴堵转。</translation>
    </message>
    <message>
        <source>L/D: the work protrudes by %1 times its diameter; at most %2 times is recommended. Support it.</source>
        <translation>长径比 (L/D)：工件伸出长度为其直径的 %1 倍；建议最多 %2 倍。请加支承。</translation>
    </message>
    <message>
        <source>Deflection: the work bends away and is left %1 mm thicker here; the limit is %2 mm.</source>
        <translation>让刀：工件弯曲退让，此处会多留 %1 mm；限值为 %2 mm。</translation>
    </message>
    <message>
        <source>Chatter: the depth of cut is %1 mm; up to %2 mm is stable at any spindle speed.</source>
        <translation>颤振：切深为 %1 mm；不超过 %2 mm 时在任何主轴转速下都稳定。</translation>
    </message>
    <message>
        <source>Rubbing: a chip thickness of %1 mm is too small to be cut; at least %2 mm is needed.</source>
        <translation>挤擦：%1 mm 的切屑厚度过小，无法切下；至少需要 %2 mm。</translation>
    </message>
    <message>
        <source>Collisions with the parts involved, and warnings with the rule that was broken, each with its time. A crash stops the spindle.</source>
        <translation>碰撞及相关部件、警告及所违反的规则，均附时间。碰撞会使主轴停止。</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>小于 %1</translation>
    </message>
    <message>
        <source>Pressing: this tool is laid on the surface and cannot be fed %1 mm into the work; its full force is reached at %2 mm.</source>
        <translation>压入：此工具只贴在表面上，不能进入工件 %1 毫米；在 %2 毫米时已达到最大力。</translation>
    </message>
</context>
<context>
    <name>handwheel::LathePanel</name>
    <message>
        <source>Value for touching off, mm</source>
        <translation>对刀值，mm</translation>
    </message>
    <message>
        <source>Touch off &amp;X</source>
        <translation>对刀 X(&amp;X)</translation>
    </message>
    <message>
        <source>The read-out shows this value for X here</source>
        <translation>将此处的 X 读数设为该值</translation>
    </message>
    <message>
        <source>Touch off &amp;Z</source>
        <translation>对刀 Z(&amp;Z)</translation>
    </message>
    <message>
        <source>The read-out shows this value for Z here</source>
        <translation>将此处的 Z 读数设为该值</translation>
    </message>
    <message>
        <source>Direction of the spindle</source>
        <translation>主轴旋转方向</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>正转(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>反转(&amp;R)</translation>
    </message>
    <message>
        <source>Speed, r/min</source>
        <translation>转速，r/min</translation>
    </message>
    <message>
        <source>Surface speed, m/min</source>
        <translation>线速度，m/min</translation>
    </message>
    <message>
        <source>Largest speed, r/min</source>
        <translation>最高转速，r/min</translation>
    </message>
    <message>
        <source>r/min</source>
        <translation>r/min</translation>
    </message>
    <message>
        <source>m/min, at most</source>
        <translation>m/min，最高</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>Feed, mm in a turn</source>
        <translation>进给，mm/r</translation>
    </message>
    <message>
        <source>mm/rev</source>
        <translation>mm/r</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>To chuck</source>
        <translation>向卡盘</translation>
    </message>
    <message>
        <source>Away</source>
        <translation>离卡盘</translation>
    </message>
    <message>
        <source>In</source>
        <translation>向内</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>向外</translation>
    </message>
    <message>
        <source>Pitch of the thread, mm</source>
        <translation>螺纹螺距，mm</translation>
    </message>
    <message>
        <source>&amp;Half-nut</source>
        <translation>开合螺母(&amp;H)</translation>
    </message>
    <message>
        <source>Closes the half-nut: the carriage follows the lead screw</source>
        <translation>合上开合螺母：大拖板随丝杠移动</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>恒定</translation>
    </message>
    <message>
        <source>Constant surface speed: the spindle turns faster the nearer the tool is to the axis</source>
        <translation>恒线速度：刀具离轴线越近，主轴转得越快</translation>
    </message>
    <message>
        <source>No automatic feed</source>
        <translation>无自动进给</translation>
    </message>
    <message>
        <source>Automatic feed of the carriage to the chuck</source>
        <translation>大拖板向卡盘自动进给</translation>
    </message>
    <message>
        <source>Automatic feed of the carriage away from the chuck</source>
        <translation>大拖板离开卡盘自动进给</translation>
    </message>
    <message>
        <source>Automatic feed of the cross slide to the axis</source>
        <translation>中拖板向轴线自动进给</translation>
    </message>
    <message>
        <source>Automatic feed of the cross slide outward</source>
        <translation>中拖板向外自动进给</translation>
    </message>
    <message>
        <source>Thread, pitch</source>
        <translation>螺纹，螺距</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>快速</translation>
    </message>
    <message>
        <source>Rapid traverse to the chuck, while held (Alt+←)</source>
        <translation>按住时快速移向卡盘 (Alt+←)</translation>
    </message>
    <message>
        <source>Rapid traverse away from the chuck, while held (Alt+→)</source>
        <translation>按住时快速移离卡盘 (Alt+→)</translation>
    </message>
    <message>
        <source>Rapid traverse in, while held (Alt+↑)</source>
        <translation>按住时快速向内移动 (Alt+↑)</translation>
    </message>
    <message>
        <source>Rapid traverse out, while held (Alt+↓)</source>
        <translation>按住时快速向外移动 (Alt+↓)</translation>
    </message>
    <message>
        <source>&amp;Left-hand</source>
        <translation>左旋(&amp;L)</translation>
    </message>
    <message>
        <source>Left-hand thread: while the spindle runs forward the lead screw takes the carriage away from the chuck. It is set while the half-nut is open.</source>
        <translation>左旋螺纹：主轴正转时，丝杠带动大拖板离开卡盘。在开合螺母打开时设定。</translation>
    </message>
    <message>
        <source>%1 not touched off</source>
        <translation>%1 未对刀</translation>
    </message>
    <message>
        <source>Turn a little of the bar, measure its diameter, enter it below, and press “Touch off X” before the cross slide moves.</source>
        <translation>将棒料车去少许，测量其直径，在下方输入，并在中拖板移动之前按“对刀 X”。</translation>
    </message>
    <message>
        <source>Touch the face of the bar with the tool, enter its height below, and press “Touch off Z” before the carriage moves.</source>
        <translation>用刀具接触棒料端面，在下方输入其高度，并在大拖板移动之前按“对刀 Z”。</translation>
    </message>
    <message>
        <source>%1 has no zero yet. %2</source>
        <translation>%1 尚无零点。%2</translation>
    </message>
    <message>
        <source>Diameter at the tip, from the workpiece zero as it was touched off; outward is positive</source>
        <translation>刀尖处的直径，从对刀所定的工件零点算起；向外为正</translation>
    </message>
    <message>
        <source>Radius at the tip, from the workpiece zero as it was touched off; outward is positive</source>
        <translation>刀尖处的半径，从对刀所定的工件零点算起；向外为正</translation>
    </message>
    <message>
        <source>From the workpiece zero as it was touched off; away from the chuck is positive</source>
        <translation>从对刀所定的工件零点算起；离开卡盘为正</translation>
    </message>
    <message>
        <source>Touching off</source>
        <translation>对刀</translation>
    </message>
    <message>
        <source>Constant surface speed</source>
        <translation>恒线速度</translation>
    </message>
    <message>
        <source>Thread and rapid traverse</source>
        <translation>螺纹和快速移动</translation>
    </message>
    <message>
        <source>Handwheels</source>
        <translation>手轮</translation>
    </message>
    <message>
        <source>Latest crash or warning</source>
        <translation>最近的碰撞或警告</translation>
    </message>
</context>
<context>
    <name>handwheel::LatheReadout</name>
    <message>
        <source>Resultant force</source>
        <translation>切削合力</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>电机功率</translation>
    </message>
    <message>
        <source>%1 of %2 %3</source>
        <translation>%1 / %2 %3</translation>
    </message>
    <message>
        <source>kW</source>
        <translation>kW</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>扭矩</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>N·m</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>%1 r/min</source>
        <translation>%1 r/min</translation>
    </message>
    <message>
        <source>Cutting speed</source>
        <translation>切削速度</translation>
    </message>
    <message>
        <source>%1 m/min</source>
        <translation>%1 m/min</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>切深</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>%1 mm/rev</source>
        <translation>%1 mm/r</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>定律</translation>
    </message>
    <message>
        <source>Kosilova</source>
        <translation>Kosilova</translation>
    </message>
    <message>
        <source>Law of the cutting force for %1. It is chosen among the settings of speed and accuracy; the material is a property of the workpiece.</source>
        <translation>%1 的切削力定律。可在速度与精度设置中选择；材料是工件的属性。</translation>
    </message>
    <message>
        <source>Ra here</source>
        <translation>此处 Ra</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Resultant of cutting, feed and radial force, and the limit of the exercise</source>
        <translation>切削力、进给力和径向力的合力，以及练习的限值</translation>
    </message>
    <message>
        <source>Power taken from the motor, and its rated power</source>
        <translation>电机输出的功率及其额定功率</translation>
    </message>
    <message>
        <source>Torque at the spindle, and the torque available</source>
        <translation>主轴扭矩及可用扭矩</translation>
    </message>
    <message>
        <source>Current spindle speed. A cut beyond the available power or torque slows it down.</source>
        <translation>当前主轴转速。切削超出可用功率或扭矩时主轴会减速。</translation>
    </message>
    <message>
        <source>Surface speed at the middle of the cut</source>
        <translation>切削中部处的线速度</translation>
    </message>
    <message>
        <source>Depth of cut, measured across the feed direction</source>
        <translation>切深，垂直于进给方向测量</translation>
    </message>
    <message>
        <source>Feed per revolution of the spindle</source>
        <translation>主轴每转的进给量</translation>
    </message>
    <message>
        <source>Roughness of the part at the tool, from feed and nose radius and from later work with file, paper or disk</source>
        <translation>刀具所在处零件的粗糙度，由进给量和刀尖圆弧半径，以及之后用锉刀、砂纸或砂轮的加工得出</translation>
    </message>
    <message>
        <source>The law of the cutting force is not valid for such a cut of %1.</source>
        <translation>该切削力定律不适用于对 %1 的这种切削。</translation>
    </message>
    <message>
        <source>%1 has no data for this material, so Kienzle is used.</source>
        <translation>%1没有该材料的数据，因此使用 Kienzle。</translation>
    </message>
    <message>
        <source>%1, unverified</source>
        <translation>%1（未核实）</translation>
    </message>
    <message>
        <source>Not all numbers of its table were compared with the handbook.</source>
        <translation>其表中的数值并未全部与手册核对。</translation>
    </message>
    <message>
        <source>Power law</source>
        <translation>幂律</translation>
    </message>
    <message>
        <source>The cut is outside the range of the network, so the power law fitted to the same data is used.</source>
        <translation>该切削超出神经网络的范围，因此使用由相同数据拟合的幂律。</translation>
    </message>
    <message>
        <source>%1, outside its range</source>
        <translation>%1（超出其适用范围）</translation>
    </message>
</context>
<context>
    <name>handwheel::LatheView</name>
    <message>
        <source>Lathe</source>
        <translation>车床</translation>
    </message>
    <message>
        <source>The tool was not mounted</source>
        <translation>刀具未安装</translation>
    </message>
    <message>
        <source>Workpiece zero</source>
        <translation>工件零点</translation>
    </message>
    <message>
        <source>The tool was moved</source>
        <translation>刀具已移动</translation>
    </message>
    <message>
        <source>The spindle turns as before.</source>
        <translation>主轴照常转动。</translation>
    </message>
    <message>
        <source>The tool does not touch the work</source>
        <translation>刀具未接触工件</translation>
    </message>
    <message>
        <source>Its tip is %1 mm from the nearest surface, measured on the radius. X was not touched off.</source>
        <translation>刀尖距最近的表面 %1 mm（按半径测量）。X 未对刀。</translation>
    </message>
    <message>
        <source>Its tip is %1 mm from the nearest face, measured along Z. Z was not touched off.</source>
        <translation>刀尖距最近的端面 %1 mm（沿 Z 测量）。Z 未对刀。</translation>
    </message>
    <message>
        <source>Turn a little of the bar, and touch off before the cross slide moves.</source>
        <translation>将棒料车去少许，并在中拖板移动之前对刀。</translation>
    </message>
    <message>
        <source>Touch or turn a face, and touch off before the carriage moves.</source>
        <translation>接触或车削端面，并在大拖板移动之前对刀。</translation>
    </message>
    <message>
        <source>Touch off anyway</source>
        <translation>仍然对刀</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>The restored material is where the tool was, so the tool was moved out of it.</source>
        <translation>恢复的材料正处于刀具所在位置，因此已将刀具从中退出。</translation>
    </message>
    <message>
        <source>The spindle stands still.</source>
        <translation>主轴静止。</translation>
    </message>
    <message>
        <source>The spindle was stopped</source>
        <translation>主轴已停止</translation>
    </message>
    <message>
        <source>The lathe of %1 stands still while another document is shown.</source>
        <translation>显示其他文档时，%1 的车床保持静止。</translation>
    </message>
    <message>
        <source>Its slides stay where they are, and its handwheels count on.</source>
        <translation>滑板保持原位，手轮继续计数。</translation>
    </message>
    <message>
        <source>The work has another size there</source>
        <translation>工件在该处的尺寸不同</translation>
    </message>
    <message>
        <source>%1 %2 mm was entered; where the tool touches, the work has %1 %3 mm. X was not touched off.</source>
        <translation>输入的是 %1 %2 mm；刀具接触处工件为 %1 %3 mm。X 未对刀。</translation>
    </message>
    <message>
        <source>Measure again, and correct the number, or take it as it is. Undo takes it back.</source>
        <translation>请重新测量并改正数值，或按此采用。可以撤销。</translation>
    </message>
    <message>
        <source>Take %1</source>
        <translation>采用 %1</translation>
    </message>
    <message>
        <source>Keep the read-out</source>
        <translation>保持显示值</translation>
    </message>
    <message>
        <source>The face is at another Z</source>
        <translation>端面位于另一个 Z 处</translation>
    </message>
    <message>
        <source>Z %1 mm was entered; from the zero of the work, the face that the tool touches is at Z %2 mm. Z was not touched off.</source>
        <translation>输入了 Z %1 mm；从工件零点算起，刀具接触的端面位于 Z %2 mm。Z 未对刀。</translation>
    </message>
</context>
<context>
    <name>handwheel::LatheWheels</name>
    <message>
        <source>Carriage</source>
        <translation>大拖板</translation>
    </message>
    <message>
        <source>Clockwise: away from the chuck. In the view: ← and →</source>
        <translation>顺时针：远离卡盘。视图中：← 和 →</translation>
    </message>
    <message>
        <source>Cross slide</source>
        <translation>中拖板</translation>
    </message>
    <message>
        <source>Compound slide</source>
        <translation>小拖板</translation>
    </message>
    <message>
        <source>Clockwise: forward. In the view: Page Up and Page Down</source>
        <translation>顺时针：向前。视图中：Page Up 和 Page Down</translation>
    </message>
    <message>
        <source>Tailstock quill</source>
        <translation>尾座套筒</translation>
    </message>
    <message>
        <source>Clockwise: out, to the work</source>
        <translation>顺时针：伸出，朝工件</translation>
    </message>
    <message>
        <source>Clockwise: in, to the axis; counts as the read-out does, on the diameter (⌀) or the radius (R). In the view: ↑ and ↓</source>
        <translation>顺时针：向内，朝轴线；与读数一样按直径 (⌀) 或半径 (R) 计数。视图中：↑ 和 ↓</translation>
    </message>
    <message>
        <source>Δ: travel since the ring was at zero; it is not a size of the part</source>
        <translation>Δ：自刻度环归零以来的行程，不是零件的尺寸</translation>
    </message>
</context>
<context>
    <name>handwheel::LessonPanel</name>
    <message>
        <source>Show a hint</source>
        <translation>显示提示</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>%1, open</source>
        <translation>%1，未完成</translation>
    </message>
    <message>
        <source>%1, done</source>
        <translation>%1，已完成</translation>
    </message>
    <message>
        <source>%1, failed</source>
        <translation>%1，未通过</translation>
    </message>
    <message>
        <source>No steps</source>
        <translation>没有步骤</translation>
    </message>
    <message>
        <source>%1 of %2 steps</source>
        <translation>%1 / %2 步</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>The time is over</source>
        <translation>时间到</translation>
    </message>
    <message>
        <source>Show another hint</source>
        <translation>显示另一条提示</translation>
    </message>
    <message>
        <source>Time since the beginning, in minutes and seconds</source>
        <translation>自开始以来的时间（分和秒）</translation>
    </message>
</context>
<context>
    <name>handwheel::LivePage</name>
    <message>
        <source>Force on</source>
        <translation>开启力</translation>
    </message>
    <message>
        <source>Test the force</source>
        <translation>测试力</translation>
    </message>
    <message>
        <source>This device has no motors: the force is only shown.</source>
        <translation>此设备没有电机：力只用于显示。</translation>
    </message>
    <message>
        <source>The device pushes gently along each axis. Hold the grip.</source>
        <translation>设备将沿每个轴轻轻推动。请握住手柄。</translation>
    </message>
    <message>
        <source>Let the device apply forces; without this it only points</source>
        <translation>允许设备施力；否则只用于指点</translation>
    </message>
    <message>
        <source>Torque that is sent to the device, of the largest that it has</source>
        <translation>发送到设备的力矩，与其最大力矩之比</translation>
    </message>
    <message>
        <source>Torque: %1 of %2 N·mm</source>
        <translation>力矩：%1 / %2 N·mm</translation>
    </message>
</context>
<context>
    <name>handwheel::LogModel</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Command line</source>
        <translation>命令行</translation>
    </message>
</context>
<context>
    <name>handwheel::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
</context>
<context>
    <name>handwheel::LongTextRow</name>
    <message>
        <source>Ctrl+Return, or leaving the field, takes the text; Esc gives it back as it was.</source>
        <translation>按 Ctrl+Return 或离开该字段即采用文本；按 Esc 恢复原来的文本。</translation>
    </message>
</context>
<context>
    <name>handwheel::MainWindow</name>
    <message>
        <source>&amp;Show the list</source>
        <translation>显示列表(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Show the whole model and its panel</source>
        <translation>显示整个模型及其面板</translation>
    </message>
    <message>
        <source>%1[*] — Handwheel</source>
        <translation>%1[*] — Handwheel</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>open a file</source>
        <translation>打开文件</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>拖放</translation>
    </message>
    <message>
        <source>files anywhere</source>
        <translation>文件到任意处</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>三维视图</translation>
    </message>
    <message>
        <source>The 3D view cannot be drawn</source>
        <translation>无法绘制三维视图</translation>
    </message>
    <message>
        <source>Files can still be repaired and saved.</source>
        <translation>仍可修复和保存文件。</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>文档</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>按键与鼠标(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Handwheel</source>
        <translation>关于 Handwheel(&amp;A)</translation>
    </message>
    <message>
        <source>Quick actions</source>
        <translation>快捷操作</translation>
    </message>
    <message>
        <source>Actions of the document</source>
        <translation>文档操作</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>面板</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>No document is open.</source>
        <translation>没有打开的文档。</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>首选项(&amp;P)…</translation>
    </message>
    <message>
        <source>The document is as it was before.</source>
        <translation>文档保持原样。</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Lengths are shown in %1: the display unit of the document, among its properties</source>
        <translation>长度以 %1 显示:文档的显示单位,见其属性</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>搜索命令</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>保真度</translation>
    </message>
    <message>
        <source>Keyboard shortcuts, mouse, units, language, autosave</source>
        <translation>键盘快捷键、鼠标、单位、语言、自动保存</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>设备(&amp;D)</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>&amp;Measure this machine</source>
        <translation>测量本机(&amp;M)</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>触摸</translation>
    </message>
    <message>
        <source>The tool failed and was closed</source>
        <translation>工具出错，已关闭</translation>
    </message>
    <message>
        <source>Measure how fast each setting of the panel “Fidelity” is on this machine: about half a minute</source>
        <translation>“保真度”面板的每项设置在本机有多快：大约半分钟</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>撤销 %1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>Sa&amp;mples and exercises</source>
        <translation>示例与练习(&amp;M)</translation>
    </message>
    <message>
        <source>As created</source>
        <translation>创建时</translation>
    </message>
    <message>
        <source>History begins when the file was opened</source>
        <translation>历史从打开文件时开始</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>文件中的状态</translation>
    </message>
    <message>
        <source>“%1” was cancelled</source>
        <translation>“%1”已取消</translation>
    </message>
    <message>
        <source>%1 is as it was.</source>
        <translation>%1 保持不变。</translation>
    </message>
</context>
<context>
    <name>handwheel::MappingForm</name>
    <message>
        <source>Button %1</source>
        <translation>按钮 %1</translation>
    </message>
</context>
<context>
    <name>handwheel::MeshDocument</name>
    <message>
        <source>Keep open</source>
        <translation>保持开放</translation>
    </message>
    <message>
        <source>No longer keep open</source>
        <translation>不再保持开放</translation>
    </message>
    <message>
        <source>Triangles reversed on opening: %1</source>
        <translation>打开时反转的三角形：%1</translation>
    </message>
</context>
<context>
    <name>handwheel::MeshHapticsProvider</name>
    <message>
        <source>Preparing to touch</source>
        <translation>正在准备触摸</translation>
    </message>
    <message>
        <source>Preparing to snap</source>
        <translation>正在准备捕捉</translation>
    </message>
</context>
<context>
    <name>handwheel::MeshUi</name>
    <message>
        <source>Defects</source>
        <translation>缺陷</translation>
    </message>
    <message>
        <source>&amp;Repair</source>
        <translation>修复(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Holes</source>
        <translation>孔洞(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Select faces</source>
        <translation>选择面(&amp;S)</translation>
    </message>
    <message>
        <source>Choose a hole, look at its patch, fill it</source>
        <translation>选择孔洞,查看补片,然后填补</translation>
    </message>
    <message>
        <source>Select faces by click, brush, lasso, connection or angle</source>
        <translation>通过点击、画笔、套索、连通或角度选择面</translation>
    </message>
    <message>
        <source>&amp;Make a face</source>
        <translation>创建面(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Reduce triangles</source>
        <translation>减少三角形(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>放置(&amp;P)</translation>
    </message>
    <message>
        <source>Sc&amp;ulpt</source>
        <translation>雕刻(&amp;U)</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Open the &amp;sample scan</source>
        <translation>打开示例扫描(&amp;S)</translation>
    </message>
    <message>
        <source>Open the sample scan</source>
        <translation>打开示例扫描</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln 个三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s)</source>
        <translation>
            <numerusform>%n 个三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n 个孔</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened %1: %2</source>
        <translation>已打开 %1：%2</translation>
    </message>
    <message numerus="yes">
        <source>%n reversed</source>
        <translation>
            <numerusform>已反转 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Repair a sample scan</source>
        <translation>修复示例扫描</translation>
    </message>
    <message>
        <source>Hole &amp;boundaries</source>
        <translation>孔洞边界(&amp;B)</translation>
    </message>
    <message>
        <source>Move, join and bridge boundary vertices; smooth a boundary; remove islands and peninsulas</source>
        <translation>移动、连接和桥接边界顶点；平滑边界；移除岛和半岛</translation>
    </message>
    <message>
        <source>Make a face from three vertices of open edges</source>
        <translation>用开放边上的三个顶点创建面</translation>
    </message>
    <message>
        <source>Reduce the number of triangles while staying close to the surface</source>
        <translation>减少三角形数量，同时贴近表面</translation>
    </message>
    <message>
        <source>Move, rotate and scale by numbers, or place on a flat face, along the axes or at the origin</source>
        <translation>按数值移动、旋转和缩放，或放到平面上、沿坐标轴或放到原点</translation>
    </message>
    <message>
        <source>Drag, smooth, inflate and flatten a surface; subdivide a patch and sculpt it at any of its levels</source>
        <translation>拖动、平滑、膨胀和压平表面；细分补片，并在其任一层级上雕刻</translation>
    </message>
    <message>
        <source>Su&amp;bdivide</source>
        <translation>细分(&amp;B)</translation>
    </message>
    <message>
        <source>Refine the whole mesh by a subdivision scheme, including open edges</source>
        <translation>用细分方案细化整个网格，包括开放边</translation>
    </message>
    <message>
        <source>Opens a sample scan with holes. Press N to see the first one, then Enter to close it.</source>
        <translation>打开一个带孔洞的示例扫描。按 N 查看第一个，再按回车键将其封闭。</translation>
    </message>
    <message>
        <source>Repair by &amp;volume</source>
        <translation>体素修复(&amp;V)</translation>
    </message>
    <message>
        <source>Replace everything by the surface of the volume that is enclosed: closed and free of self-intersections, without details smaller than a voxel</source>
        <translation>用所围体积的表面替换全部内容：封闭且无自相交，不含小于一个体素的细节</translation>
    </message>
</context>
<context>
    <name>handwheel::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>还有 %n 条</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the next message</source>
        <translation>显示下一条消息</translation>
    </message>
</context>
<context>
    <name>handwheel::MethodTable</name>
    <message>
        <source>Methods side by side</source>
        <translation>方法对照</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>mm²</source>
        <translation>mm²</translation>
    </message>
    <message>
        <source>Area of the patch</source>
        <translation>补片的面积</translation>
    </message>
    <message>
        <source>The sharpest edge, that of the hole included</source>
        <translation>最尖锐的边，包括孔洞边界上的边</translation>
    </message>
    <message>
        <source>%1 It took %2 ms.</source>
        <translation>%1用时 %2 毫秒。</translation>
    </message>
    <message>
        <source>Root mean square over all edges: %1</source>
        <translation>所有边的均方根:%1</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>弯折</translation>
    </message>
    <message>
        <source>Triangles of the patch</source>
        <translation>补片的三角形数</translation>
    </message>
</context>
<context>
    <name>handwheel::NumberField</name>
    <message>
        <source>in %1</source>
        <translation>单位 %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>不小于 %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>不大于 %1</translation>
    </message>
    <message>
        <source>Must be at least %1.</source>
        <translation>不得小于 %1。</translation>
    </message>
    <message>
        <source>Must be at most %1.</source>
        <translation>不得大于 %1。</translation>
    </message>
</context>
<context>
    <name>handwheel::PairsDialog</name>
    <message>
        <source>Pairs that may touch</source>
        <translation>可接触的成对物体</translation>
    </message>
    <message>
        <source>Nothing meets where the robot is, nor on the selected path.</source>
        <translation>机器人所在处和选中路径上均无相遇。</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>Checked pairs may touch: nothing is proven about them. Neighbouring links may touch anyway.</source>
        <translation>勾选的配对允许接触：不对其作任何证明。相邻的连杆本来就允许接触。</translation>
    </message>
</context>
<context>
    <name>handwheel::PartSurfaces</name>
    <message>
        <source>Finding the edges of %1</source>
        <translation>正在查找 %1 的边</translation>
    </message>
</context>
<context>
    <name>handwheel::PathChecks</name>
    <message>
        <source>Verifying %1</source>
        <translation>正在验证 %1</translation>
    </message>
    <message>
        <source>Comparing the cell with what was verified</source>
        <translation>正在将单元与验证时的状态进行比较</translation>
    </message>
</context>
<context>
    <name>handwheel::PathDock</name>
    <message>
        <source>Pl&amp;ay the path</source>
        <translation>播放路径(&amp;A)</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>The path is being verified.</source>
        <translation>正在验证路径。</translation>
    </message>
    <message>
        <source>Select a path in the panel, or plan one, to play it here.</source>
        <translation>请在面板中选择或规划一条路径，以便在此播放。</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Margin to the limits</source>
        <translation>距限位余量</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Manipulability</source>
        <translation>可操作度</translation>
    </message>
    <message>
        <source>Collision: %1 with %2</source>
        <translation>碰撞：%1 与 %2</translation>
    </message>
    <message>
        <source>; collision: %1 with %2</source>
        <translation>；碰撞：%1 与 %2</translation>
    </message>
    <message>
        <source>Plays the path on a time line, with its clearance and its collisions</source>
        <translation>在时间轴上播放路径，显示间隙和碰撞</translation>
    </message>
    <message>
        <source>Clearance to keep</source>
        <translation>须保持的间隙</translation>
    </message>
    <message>
        <source>The straight line to the second place cannot be begun.</source>
        <translation>到第二个位置的直线无法开始。</translation>
    </message>
    <message>
        <source>Too near: %1 to %2</source>
        <translation>过近：%1 与 %2</translation>
    </message>
    <message>
        <source>X %1  Y %2  Z %3 mm</source>
        <translation>X %1  Y %2  Z %3 mm</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1（在 %2 中）</translation>
    </message>
    <message>
        <source>To place %1 of %2: %3</source>
        <translation>到第 %1 点（共 %2 点）：%3</translation>
    </message>
</context>
<context>
    <name>handwheel::PathGuides</name>
    <message>
        <source>Finding the curve along %1</source>
        <translation>正在求沿 %1 的曲线</translation>
    </message>
</context>
<context>
    <name>handwheel::PlanDialog</name>
    <message>
        <source>Plan a path</source>
        <translation>规划路径</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>规划(&amp;P)</translation>
    </message>
    <message>
        <source>The path begins where it ends: choose another end.</source>
        <translation>路径的起点与终点相同：请选择其他终点。</translation>
    </message>
    <message>
        <source>The path is proven free of collisions everywhere between its places.</source>
        <translation>已证明路径在各位置之间处处无碰撞。</translation>
    </message>
    <message>
        <source>Critical configurations and targets on the way, from the top down (drag to reorder):</source>
        <translation>途经的关键位形和目标点，自上而下（拖动可重新排序）：</translation>
    </message>
    <message>
        <source>The robot has simplified shapes, smaller than its own in places: keep a clearance, or use its maker&apos;s shapes by a URDF.</source>
        <translation>该机器人采用简化外形，局部小于真实外形：请保持间隙，或通过 URDF 使用制造商的外形。</translation>
    </message>
</context>
<context>
    <name>handwheel::PlanTree</name>
    <message>
        <source>Configurations</source>
        <translation>位形</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: critical</source>
        <translation>%1：关键</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>planned for</source>
        <translation>当前规划</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>属于 %1</translation>
    </message>
    <message>
        <source>Configurations, paths, targets and frames</source>
        <translation>构型、路径、目标和坐标系</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
</context>
<context>
    <name>handwheel::PlotWidget</name>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1:%2,%3</translation>
    </message>
</context>
<context>
    <name>handwheel::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Autosave</source>
        <translation>自动保存</translation>
    </message>
    <message>
        <source>Mouse navigation</source>
        <translation>鼠标导航</translation>
    </message>
    <message>
        <source>Move the view as in</source>
        <translation>视图操作方式仿照</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>长度单位</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>毫米 (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>厘米 (cm)</translation>
    </message>
    <message>
        <source>Metres (m)</source>
        <translation>米 (m)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>英寸 (in)</translation>
    </message>
    <message>
        <source>Lengths of new documents</source>
        <translation>新文档的长度</translation>
    </message>
    <message>
        <source>Each document can show another unit. Every field takes all units: “1 in + 2 mm”.</source>
        <translation>每个文档可显示不同的单位。所有输入框都接受任意单位：“1 in + 2 mm”。</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Save a recovery copy while working</source>
        <translation>工作时保存恢复副本</translation>
    </message>
    <message>
        <source>Seconds between recovery copies</source>
        <translation>恢复副本的间隔秒数</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>The copy is kept beside your files, never in their place; after a crash it is offered to you.</source>
        <translation>副本与您的文件分开保存，绝不覆盖；崩溃后会提供恢复。</translation>
    </message>
    <message>
        <source>A space mouse moves the view</source>
        <translation>空间鼠标移动视图</translation>
    </message>
    <message>
        <source>Speed of the space mouse</source>
        <translation>空间鼠标的速度</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Its speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Its axes are set in the panel “Device” while it is the chosen device.</source>
        <translation>当它是所选设备时，可在“设备”面板中设置其轴。</translation>
    </message>
    <message>
        <source>Takes effect at the next start.</source>
        <translation>下次启动时生效。</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>声音</translation>
    </message>
    <message>
        <source>Play the sound of machines</source>
        <translation>播放机床声音</translation>
    </message>
    <message>
        <source>Volume of machines</source>
        <translation>机床音量</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>音量</translation>
    </message>
    <message>
        <source>Spindle and cut, from speed, feed, force and wear. Louder means more force; a deep tone means chatter.</source>
        <translation>主轴与切削的声音，取决于转速、进给、力和磨损。声音越大表示力越大；低沉的音调表示颤振。</translation>
    </message>
    <message>
        <source>At the latest after</source>
        <translation>最迟间隔</translation>
    </message>
    <message>
        <source>It is made within a second after each edit, less often where that takes long.</source>
        <translation>每次编辑后一秒内生成副本；若耗时较长，则降低频率。</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramDock</name>
    <message>
        <source>&amp;Program</source>
        <translation>程序(&amp;P)</translation>
    </message>
    <message>
        <source>Run lathe programs on the part, and write them</source>
        <translation>对零件运行车床程序，以及编写程序</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Program zero</source>
        <translation>程序零点</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramEditor</name>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramPanel</name>
    <message>
        <source>Errors and collisions</source>
        <translation>错误与碰撞</translation>
    </message>
    <message>
        <source>A click jumps to the line, and shows the place of a collision.</source>
        <translation>单击可跳到该行，并显示碰撞位置。</translation>
    </message>
    <message>
        <source>Open a program, drop one here, or write one.</source>
        <translation>打开程序、将程序拖放到此处，或编写程序。</translation>
    </message>
    <message>
        <source>Run the program first.</source>
        <translation>请先运行程序。</translation>
    </message>
    <message>
        <source>Make</source>
        <translation>生成</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>代码格式</translation>
    </message>
    <message>
        <source>The control for which the program is written. It is recognised when a program is opened.</source>
        <translation>程序所针对的数控系统。打开程序时会自动识别。</translation>
    </message>
    <message>
        <source>LinuxCNC</source>
        <translation>LinuxCNC</translation>
    </message>
    <message>
        <source>Fanuc, system A</source>
        <translation>Fanuc，A 系统</translation>
    </message>
    <message>
        <source>Nose radius of the tools</source>
        <translation>刀具的刀尖圆弧半径</translation>
    </message>
    <message>
        <source>Nose radius of all tools; 0: the tools are points</source>
        <translation>所有刀具的刀尖圆弧半径；0：刀具视为点</translation>
    </message>
    <message>
        <source>Nose</source>
        <translation>刀尖</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>Simulate the program on the part; the document stays as it is</source>
        <translation>在零件上仿真程序；文档保持不变</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop this run</source>
        <translation>停止此次运行</translation>
    </message>
    <message>
        <source>&amp;Cut the work</source>
        <translation>切削工件(&amp;C)</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>运行进度</translation>
    </message>
    <message>
        <source>Line %1: </source>
        <translation>第 %1 行： </translation>
    </message>
    <message>
        <source>Line %1, column %2: </source>
        <translation>第 %1 行，第 %2 列： </translation>
    </message>
    <message>
        <source>&amp;Tools…</source>
        <translation>刀具(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Tools (%1)…</source>
        <translation>刀具 (%1)(&amp;T)…</translation>
    </message>
    <message>
        <source>Generate a program from the recorded passes or for the target</source>
        <translation>根据记录的走刀或针对目标生成程序</translation>
    </message>
    <message>
        <source>Tool table of the program: nose radii, holders and offsets</source>
        <translation>程序的刀具表：刀尖圆弧半径、刀杆和偏置</translation>
    </message>
    <message>
        <source>Tool post</source>
        <translation>刀架</translation>
    </message>
    <message>
        <source>Tool post of the machine, and the side that the inserts face: they decide between M3 and M4. X+ points to the post; seen from above, G2, G3, G41 and G42 appear reversed if it is in front.</source>
        <translation>机床的刀架以及刀片的朝向：二者决定使用 M3 还是 M4。X+ 指向刀架；刀架在前时，从上方看 G2、G3、G41 和 G42 的方向相反。</translation>
    </message>
    <message>
        <source>Behind, insert down (M3)</source>
        <translation>后置，刀片朝下 (M3)</translation>
    </message>
    <message>
        <source>Behind, insert up (M4)</source>
        <translation>后置，刀片朝上 (M4)</translation>
    </message>
    <message>
        <source>In front, insert down (M4)</source>
        <translation>前置，刀片朝下 (M4)</translation>
    </message>
    <message>
        <source>In front, insert up (M3)</source>
        <translation>前置，刀片朝上 (M3)</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramPlayer</name>
    <message>
        <source>One line back</source>
        <translation>后退一行</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>One line on</source>
        <translation>前进一行</translation>
    </message>
    <message>
        <source>Time in the program</source>
        <translation>程序中的时间</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Speed relative to that of the machine</source>
        <translation>相对于机床速度的倍数</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramSearchBar</name>
    <message>
        <source>Find in the program</source>
        <translation>在程序中查找</translation>
    </message>
    <message>
        <source>Previous (Shift+F3)</source>
        <translation>上一个 (Shift+F3)</translation>
    </message>
    <message>
        <source>Next (F3)</source>
        <translation>下一个 (F3)</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>关闭 (Esc)</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramSession</name>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1：%2。%3</translation>
    </message>
    <message>
        <source>&amp;Open program…</source>
        <translation>打开程序(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a program: .ngc, .nc, .tap or .txt</source>
        <translation>打开程序：.ngc、.nc、.tap 或 .txt</translation>
    </message>
    <message>
        <source>&amp;Save program</source>
        <translation>保存程序(&amp;S)</translation>
    </message>
    <message>
        <source>Save the program in its file (Ctrl+S in the text)</source>
        <translation>将程序保存到其文件（在文本中按 Ctrl+S）</translation>
    </message>
    <message>
        <source>Save program &amp;as…</source>
        <translation>程序另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the program under another name</source>
        <translation>以其他名称保存程序</translation>
    </message>
    <message>
        <source>Program from &amp;passes…</source>
        <translation>由走刀生成程序(&amp;P)…</translation>
    </message>
    <message>
        <source>Write the passes that cut this part as a program</source>
        <translation>将切削此零件的走刀写成程序</translation>
    </message>
    <message>
        <source>&amp;Rough and finish…</source>
        <translation>粗车与精车(&amp;R)…</translation>
    </message>
    <message>
        <source>Write a program that makes the target from the part. It is simulated before it is shown.</source>
        <translation>编写由零件加工出目标的程序。显示前先经仿真。</translation>
    </message>
    <message>
        <source>Untitled program</source>
        <translation>未命名程序</translation>
    </message>
    <message>
        <source>Checking the program</source>
        <translation>正在检查程序</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s): the program does not run as it is.</source>
        <translation>
            <numerusform>%n 个错误：程序目前无法运行。</numerusform>
        </translation>
    </message>
    <message>
        <source>Open a program</source>
        <translation>打开程序</translation>
    </message>
    <message>
        <source>Programs (%1);;All files (*)</source>
        <translation>程序 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>无法打开 %1</translation>
    </message>
    <message>
        <source>Program read from %1</source>
        <translation>已从 %1 读取程序</translation>
    </message>
    <message>
        <source>Save the program</source>
        <translation>保存程序</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>正在保存 %1</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>无法保存 %1</translation>
    </message>
    <message>
        <source>Program saved as %1</source>
        <translation>程序已保存为 %1</translation>
    </message>
    <message>
        <source>Program from passes</source>
        <translation>由走刀生成程序</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>写入(&amp;W)</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>主轴转速</translation>
    </message>
    <message>
        <source>r/min</source>
        <translation>r/min</translation>
    </message>
    <message>
        <source>Writing the program</source>
        <translation>正在编写程序</translation>
    </message>
    <message>
        <source>The passes cannot be written as a program</source>
        <translation>无法将走刀写成程序</translation>
    </message>
    <message>
        <source>Rough and finish</source>
        <translation>粗车与精车</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>切深</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>Nose radius</source>
        <translation>刀尖圆弧半径</translation>
    </message>
    <message>
        <source>Feed of roughing</source>
        <translation>粗车进给</translation>
    </message>
    <message>
        <source>mm/rev</source>
        <translation>mm/r</translation>
    </message>
    <message>
        <source>Feed of finishing</source>
        <translation>精车进给</translation>
    </message>
    <message>
        <source>Surface speed</source>
        <translation>线速度</translation>
    </message>
    <message>
        <source>m/min</source>
        <translation>m/min</translation>
    </message>
    <message>
        <source>Writing and simulating the cycles</source>
        <translation>正在编写并仿真循环</translation>
    </message>
    <message>
        <source>There are no cycles for this target</source>
        <translation>没有适用于此目标的循环</translation>
    </message>
    <message>
        <source>Run the program first.</source>
        <translation>请先运行程序。</translation>
    </message>
    <message>
        <source>Running the program</source>
        <translation>正在运行程序</translation>
    </message>
    <message>
        <source>The program could not be run</source>
        <translation>无法运行程序</translation>
    </message>
    <message>
        <source>The run was cancelled.</source>
        <translation>运行已取消。</translation>
    </message>
    <message>
        <source>Cut the part as the program does: one step of the history</source>
        <translation>按程序切削零件：在历史记录中为一步</translation>
    </message>
    <message>
        <source>The program does not touch the part.</source>
        <translation>程序未接触零件。</translation>
    </message>
    <message>
        <source>collision: the tip is beyond the face of the chuck, at ⌀ %1, Z %2.</source>
        <translation>碰撞：刀尖越过卡盘端面，位于 ⌀ %1，Z %2。</translation>
    </message>
    <message>
        <source>collision: a rapid move through material, to ⌀ %1, Z %2.</source>
        <translation>碰撞：快速移动穿过材料，至 ⌀ %1，Z %2。</translation>
    </message>
    <message numerus="yes">
        <source>%n collision(s).</source>
        <translation>
            <numerusform>%n 处碰撞。</numerusform>
        </translation>
    </message>
    <message>
        <source>No collision.</source>
        <translation>无碰撞。</translation>
    </message>
    <message>
        <source>The program does not touch the part. %1</source>
        <translation>程序未接触零件。%1</translation>
    </message>
    <message>
        <source>Time with tool changes %1. It removes %2 mm³. %3</source>
        <translation>含换刀的时间 %1。去除 %2 mm³。%3</translation>
    </message>
    <message>
        <source>Run program</source>
        <translation>运行程序</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>运行 %1</translation>
    </message>
    <message>
        <source>Cutting up to the line</source>
        <translation>正在切削到该行</translation>
    </message>
    <message>
        <source>collision: a feed into material with the spindle at rest, to ⌀ %1, Z %2.</source>
        <translation>碰撞：主轴静止时切入材料，到 ⌀ %1，Z %2。</translation>
    </message>
    <message>
        <source>Drill for the bore</source>
        <translation>内孔的钻头</translation>
    </message>
    <message>
        <source>collision: %3 meets %4, on the way to ⌀ %1, Z %2.</source>
        <translation>碰撞：%3 与 %4 相碰，在移往 ⌀ %1，Z %2 途中。</translation>
    </message>
    <message numerus="yes">
        <source>%n collision(s) recorded, which undo does not take back.</source>
        <translation>
            <numerusform>已记录 %n 处碰撞，撤销不会将其取消。</numerusform>
        </translation>
    </message>
    <message>
        <source>Change the tools of the program</source>
        <translation>更改程序的刀具</translation>
    </message>
    <message>
        <source>Writes a program that makes the target from this part, a bore included, through or blind. It is simulated first, and refused where it collides or cuts into the target.</source>
        <translation>编写由此零件加工出目标的程序，包括内孔（通孔或盲孔）。先经仿真；若发生碰撞或切入目标，则不予采用。</translation>
    </message>
    <message>
        <source>Diameter. A bore, through or blind, is drilled, roughed and finished with a boring bar; 0 leaves it as it is.</source>
        <translation>直径。内孔（通孔或盲孔）先钻孔，再用镗刀粗镗和精镗；0 表示保持原样。</translation>
    </message>
    <message>
        <source>The view shows the part as it is. Run the program to see what it would cut.</source>
        <translation>视图显示零件的当前状态。运行程序可查看它将切削的结果。</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>…and %1 more, in the list of the program.</source>
        <translation>…还有 %1 项，见程序的列表。</translation>
    </message>
    <message numerus="yes">
        <source>The program has %n collision(s); nothing is cut yet</source>
        <translation>
            <numerusform>程序有 %n 处碰撞；尚未切削</numerusform>
        </translation>
    </message>
    <message>
        <source>If you cut anyway, collisions are recorded as on the machine, and undo does not take them back.</source>
        <translation>如果仍要切削，碰撞会像在机床上一样被记录，撤销不会将其取消。</translation>
    </message>
    <message>
        <source>Cut anyway</source>
        <translation>仍然切削</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Depth of a roughing cut, on the radius</source>
        <translation>每次粗车的切深（半径值）</translation>
    </message>
    <message>
        <source>Allowance for the finishing cut</source>
        <translation>精车余量</translation>
    </message>
    <message>
        <source>Largest spindle speed</source>
        <translation>最高主轴转速</translation>
    </message>
    <message>
        <source>resultant force: up to %1 N, where the lathe of the exercise allows %2 N. It is in the report of the exercise.</source>
        <translation>切削合力：最大 %1 N，而练习的车床只允许 %2 N。已记入练习的报告。</translation>
    </message>
    <message>
        <source>motor power: up to %1 kW, where the lathe of the exercise has %2 kW. It is in the report of the exercise.</source>
        <translation>电机功率：最大 %1 kW，而练习的车床只有 %2 kW。将写入练习的报告。</translation>
    </message>
    <message>
        <source>Cut the part as the program does. If it collides, its collisions are shown first.</source>
        <translation>按程序切削零件。若有碰撞，会先显示其碰撞。</translation>
    </message>
    <message>
        <source>Cut: %1 mm³ removed. Undo restores them.</source>
        <translation>切削：已去除 %1 mm³。撤销可恢复。</translation>
    </message>
    <message>
        <source>The program or the part was changed since: run it again.</source>
        <translation>此后程序或零件已更改：请重新运行。</translation>
    </message>
    <message>
        <source>This exercise is to be done by hand: it does not allow programs to be made, run, or to cut.</source>
        <translation>本练习须手动完成：不允许编写、运行程序或用程序切削。</translation>
    </message>
    <message>
        <source>The passes that cut this part become a program in the chosen dialect, with their feed per revolution. It is shown in the editor; undo restores the present text.</source>
        <translation>加工此零件的各次走刀将按所选方言成为程序，并保留其每转进给。程序显示在编辑器中；撤销可恢复当前文本。</translation>
    </message>
    <message>
        <source>The program leaves material over the target</source>
        <translation>程序在目标之上留有材料</translation>
    </message>
    <message>
        <source>In the bore it is up to %1 mm, at Z %2 mm.</source>
        <translation>在孔中最多 %1 mm，位于 Z %2 mm 处。</translation>
    </message>
    <message>
        <source>It is up to %1 mm, at Z %2 mm.</source>
        <translation>最多 %1 mm，位于 Z %2 mm 处。</translation>
    </message>
    <message>
        <source>Cut the rest by hand, or by a program of your own.</source>
        <translation>请手工或用您自己的程序切除其余部分。</translation>
    </message>
    <message>
        <source>Choose a drill of %1 mm for the bore.</source>
        <translation>请为孔选择 %1 mm 的钻头。</translation>
    </message>
    <message>
        <source>No drill makes it: %1.</source>
        <translation>没有钻头能加工它：%1。</translation>
    </message>
    <message>
        <source>Nothing was cut yet.</source>
        <translation>尚未切削。</translation>
    </message>
    <message>
        <source>There is no target.</source>
        <translation>没有目标。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>The others are named at the head of the program.</source>
        <translation>其余的列在程序开头。</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es) were left out of the program</source>
        <translation>
            <numerusform>程序中省略了 %n 次走刀</numerusform>
        </translation>
    </message>
    <message>
        <source>Do their work by hand, after the program.</source>
        <translation>请在程序之后手动完成这些走刀。</translation>
    </message>
    <message>
        <source>Change the tool post</source>
        <translation>更改刀架</translation>
    </message>
    <message>
        <source>collision: a feed into material with the spindle at rest, which M6 has stopped, to ⌀ %1, Z %2. Write M3 or M4 after M6.</source>
        <translation>碰撞：主轴静止（被 M6 停止）时切入材料，到 ⌀ %1，Z %2。请在 M6 之后写 M3 或 M4。</translation>
    </message>
</context>
<context>
    <name>handwheel::PropertyRow</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>handwheel::ProximityDock</name>
    <message>
        <source>Distance &amp;queries…</source>
        <translation>距离查询(&amp;Q)…</translation>
    </message>
    <message>
        <source>Measures what the distances of the robot from its obstacles cost, in three scenarios</source>
        <translation>在三种情形下测量机器人与障碍物之间距离查询的开销</translation>
    </message>
    <message>
        <source>Distance queries</source>
        <translation>距离查询</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>情形</translation>
    </message>
    <message>
        <source>Where it stands</source>
        <translation>当前位置</translation>
    </message>
    <message>
        <source>1: apart by more than the tolerance</source>
        <translation>1：距离大于容差</translation>
    </message>
    <message>
        <source>2: nearer than the tolerance</source>
        <translation>2：距离小于容差</translation>
    </message>
    <message>
        <source>3: colliding</source>
        <translation>3：碰撞</translation>
    </message>
    <message>
        <source>&amp;Measure the distance queries</source>
        <translation>测量距离查询(&amp;M)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Costs of the distance queries</source>
        <translation>距离查询的开销</translation>
    </message>
    <message>
        <source>CPU time (µs)</source>
        <translation>CPU时间(µs)</translation>
    </message>
    <message>
        <source>At most (µs)</source>
        <translation>最大(µs)</translation>
    </message>
    <message>
        <source>C1 closest points</source>
        <translation>C1 最近点</translation>
    </message>
    <message>
        <source>C2 nearer than tolerance</source>
        <translation>C2 小于容差</translation>
    </message>
    <message>
        <source>C3 colliding</source>
        <translation>C3 碰撞</translation>
    </message>
    <message>
        <source>C4 all contacts</source>
        <translation>C4 所有接触</translation>
    </message>
    <message>
        <source>CPU time of a step: the median, and the largest. Pairs of bounding volumes, and of triangles or solids, that were compared in a step: the mean</source>
        <translation>每步的CPU时间：中位数和最大值。每步比较的包围体对数以及三角形或实体对数：平均值</translation>
    </message>
    <message>
        <source>The cell is being prepared.</source>
        <translation>正在准备单元。</translation>
    </message>
    <message>
        <source>The queries are being measured.</source>
        <translation>正在测量查询。</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>尚未测量。</translation>
    </message>
    <message>
        <source>%1 The cell was changed since.</source>
        <translation>%1此后单元已更改。</translation>
    </message>
    <message>
        <source>The cell could not be prepared.</source>
        <translation>无法准备单元。</translation>
    </message>
    <message>
        <source>Measuring the distance queries</source>
        <translation>正在测量距离查询</translation>
    </message>
    <message>
        <source>The robot does not get into scenario %1.</source>
        <translation>机器人无法进入情形%1。</translation>
    </message>
    <message>
        <source>Scenario 1, apart: there is no obstacle.</source>
        <translation>情形1，分离：没有障碍物。</translation>
    </message>
    <message>
        <source>Scenario 1, apart: %1 from the nearest obstacle.</source>
        <translation>情形1，分离：距最近障碍物%1。</translation>
    </message>
    <message>
        <source>Scenario 2, near: %1 from the nearest obstacle.</source>
        <translation>情形2，接近：距最近障碍物%1。</translation>
    </message>
    <message numerus="yes">
        <source>Scenario 3, colliding: %Ln pair(s) of triangles or solids meet.</source>
        <translation>
            <numerusform>情形3，碰撞：%Ln对三角形或实体相交。</numerusform>
        </translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>包围体</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>对数</translation>
    </message>
</context>
<context>
    <name>handwheel::ReadOnlyRow</name>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
</context>
<context>
    <name>handwheel::RecordingIndicator</name>
    <message>
        <source>The device is being recorded. Click to show the recordings</source>
        <translation>正在录制设备。单击以显示录制内容</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>录制 %1</translation>
    </message>
</context>
<context>
    <name>handwheel::Recordings</name>
    <message>
        <source>&amp;Record the device</source>
        <translation>录制设备(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Play the recording</source>
        <translation>播放录制(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Leave the recording</source>
        <translation>离开录制(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Export as CSV…</source>
        <translation>导出为 CSV(&amp;E)…</translation>
    </message>
    <message>
        <source>Re&amp;name the recording</source>
        <translation>重命名录制(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Delete the recording</source>
        <translation>删除录制(&amp;D)</translation>
    </message>
    <message>
        <source>Let the cursor follow the recording, or pause it</source>
        <translation>让光标跟随录制，或暂停</translation>
    </message>
    <message>
        <source>Show the device again</source>
        <translation>重新显示设备</translation>
    </message>
    <message>
        <source>Write the recording as a table</source>
        <translation>将录制写为表格</translation>
    </message>
    <message>
        <source>Give the recording another name</source>
        <translation>给录制换一个名称</translation>
    </message>
    <message>
        <source>Delete the recording from the document</source>
        <translation>从文档中删除该录制</translation>
    </message>
    <message>
        <source>Rename a recording</source>
        <translation>重命名录制</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>录制 %1</translation>
    </message>
    <message>
        <source>Record the device</source>
        <translation>录制设备</translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln sample(s)</source>
        <translation>
            <numerusform>%1：%Ln 个采样</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete a recording</source>
        <translation>删除录制</translation>
    </message>
    <message>
        <source>Export the recording</source>
        <translation>导出录制</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>无法保存 %1</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>正在写入 %1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Stop &amp;recording</source>
        <translation>停止录制(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Pause the recording</source>
        <translation>暂停录制(&amp;P)</translation>
    </message>
    <message>
        <source>Record the position and the force of the device until pressed again</source>
        <translation>记录设备的位置和力，直到再次按下</translation>
    </message>
</context>
<context>
    <name>handwheel::RecordingsPage</name>
    <message>
        <source>Recordings</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>录制中的位置</translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln sample(s)</source>
        <translation>
            <numerusform>%1，%Ln 个采样</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln missing</source>
        <translation>
            <numerusform>，缺少 %Ln 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Kept with the document.</source>
        <translation>随文档保存。</translation>
    </message>
</context>
<context>
    <name>handwheel::RemeshAction</name>
    <message>
        <source>Make &amp;mesh…</source>
        <translation>生成网格(&amp;M)…</translation>
    </message>
    <message>
        <source>Open the surface as a mesh, with as many triangles as are wanted</source>
        <translation>将表面作为网格打开，三角形数量可自定</translation>
    </message>
    <message>
        <source>Make a mesh</source>
        <translation>生成网格</translation>
    </message>
    <message>
        <source>The mesh becomes a document of its own. It is closed and manifold, and meets itself nowhere.</source>
        <translation>网格成为单独的文档。它是封闭的流形，处处无自相交。</translation>
    </message>
    <message>
        <source>&amp;Make mesh</source>
        <translation>生成网格(&amp;M)</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>约 %1</translation>
    </message>
    <message>
        <source>being counted…</source>
        <translation>正在计数…</translation>
    </message>
    <message>
        <source>Counting triangles</source>
        <translation>正在计算三角形数量</translation>
    </message>
    <message>
        <source>Making the mesh</source>
        <translation>正在生成网格</translation>
    </message>
    <message>
        <source>The mesh was not made</source>
        <translation>未生成网格</translation>
    </message>
    <message>
        <source>Mesh made of %1 triangle(s): %2 of them left</source>
        <translation>已由 %1 个三角形生成网格：保留其中 %2 个</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>约 %1 s</translation>
    </message>
</context>
<context>
    <name>handwheel::RepairActions</name>
    <message>
        <source>&amp;Repair all</source>
        <translation>全部修复(&amp;R)</translation>
    </message>
    <message>
        <source>Remove &amp;debris</source>
        <translation>移除碎片(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Go one by one</source>
        <translation>逐个处理(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>填补(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Keep open</source>
        <translation>保持开放(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Preview</source>
        <translation>预览(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next hole</source>
        <translation>下一个孔洞(&amp;N)</translation>
    </message>
    <message>
        <source>Pre&amp;vious hole</source>
        <translation>上一个孔洞(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Clear selection</source>
        <translation>清除选择(&amp;C)</translation>
    </message>
    <message>
        <source>Look at one hole after the other</source>
        <translation>逐个查看孔洞</translation>
    </message>
    <message>
        <source>Fill the selected hole</source>
        <translation>填补所选孔洞</translation>
    </message>
    <message>
        <source>Show the patch of the selected hole before it is filled</source>
        <translation>填补前显示所选孔洞的补片</translation>
    </message>
    <message>
        <source>Go to the next hole</source>
        <translation>转到下一个孔洞</translation>
    </message>
    <message>
        <source>Go to the previous hole</source>
        <translation>转到上一个孔洞</translation>
    </message>
    <message>
        <source>Clear the selection and the preview</source>
        <translation>清除选择和预览</translation>
    </message>
    <message>
        <source>Mark this opening as intended: “Repair all” does not close it</source>
        <translation>将此开口标记为有意保留：“全部修复”不会封闭它</translation>
    </message>
    <message>
        <source>&amp;Undo repair</source>
        <translation>撤销修复(&amp;U)</translation>
    </message>
    <message>
        <source>Remove all pieces that are listed as debris; the list says which these are</source>
        <translation>移除所有列为碎片的部分；列表中说明了是哪些</translation>
    </message>
    <message>
        <source>Repair by &amp;volume…</source>
        <translation>体素修复(&amp;V)…</translation>
    </message>
    <message>
        <source>Choose the size of the voxels, and replace everything by the surface of the volume that is enclosed</source>
        <translation>选择体素大小，并用所围体积的表面替换全部内容</translation>
    </message>
    <message>
        <source>Fill all holes except those kept open, resolve self-intersections, and repair the other defects except debris, as one step</source>
        <translation>一步填补所有未保持开放的孔洞，消除自相交，并修复除碎片外的其他缺陷</translation>
    </message>
    <message>
        <source>Undo all that the last repair has changed</source>
        <translation>撤销上次修复所做的全部更改</translation>
    </message>
    <message>
        <source>The last repair has tried it; the list says why defects remain.</source>
        <translation>上次修复已尝试过；列表说明了缺陷仍存在的原因。</translation>
    </message>
    <message>
        <source>Self-intersections are still being searched for.</source>
        <translation>仍在查找自相交。</translation>
    </message>
    <message>
        <source>There is nothing that it would repair.</source>
        <translation>没有它会修复的内容。</translation>
    </message>
    <message>
        <source>There is no debris.</source>
        <translation>没有碎片。</translation>
    </message>
    <message>
        <source>There are no holes.</source>
        <translation>没有孔洞。</translation>
    </message>
    <message>
        <source>Select a hole first.</source>
        <translation>请先选择一个孔洞。</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>未选择任何内容。</translation>
    </message>
    <message>
        <source>The last change was not a repair.</source>
        <translation>上一次更改不是修复。</translation>
    </message>
    <message>
        <source>This opening is marked as intended.</source>
        <translation>此开口已标记为有意保留。</translation>
    </message>
    <message>
        <source>No patch fits; the list says why.</source>
        <translation>没有合适的补片；列表说明了原因。</translation>
    </message>
</context>
<context>
    <name>handwheel::RepairDemo</name>
    <message>
        <source>&amp;Watch the hand repair a scan</source>
        <translation>观看手修复扫描件(&amp;W)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>The hand opens the sample</source>
        <translation>手打开示例</translation>
    </message>
    <message>
        <source>1 of 5: choose the hole</source>
        <translation>第 1 步，共 5 步：选择孔</translation>
    </message>
    <message>
        <source>3 of 5: stitch</source>
        <translation>第 3 步，共 5 步：缝合</translation>
    </message>
    <message>
        <source>4 of 5: fill both parts</source>
        <translation>第 4 步，共 5 步：填补两部分</translation>
    </message>
    <message>
        <source>5 of 5: sculpt the patch</source>
        <translation>第 5 步，共 5 步：雕刻补片</translation>
    </message>
    <message>
        <source>The seam of both patches is smoothed as a part of the whole surface.</source>
        <translation>两块补片之间的接缝作为整个表面的一部分被平滑。</translation>
    </message>
    <message>
        <source>The simulated hand repairs a hole of the sample with the same tools that you have</source>
        <translation>模拟手使用与您相同的工具修复示例中的一个孔洞</translation>
    </message>
    <message>
        <source>You can do the same with a device or with the mouse.</source>
        <translation>您用设备或鼠标都可以做同样的操作。</translation>
    </message>
    <message>
        <source>Boundary vertices attract the tip. The first button chooses the hole.</source>
        <translation>边界顶点会吸引尖端。第一个按钮选择孔洞。</translation>
    </message>
    <message>
        <source>2 of 5: smooth its boundary</source>
        <translation>第 2 步，共 5 步：平滑其边界</translation>
    </message>
    <message>
        <source>Shift+S shows a preview. The second button applies it.</source>
        <translation>Shift+S 显示预览。第二个按钮应用它。</translation>
    </message>
    <message>
        <source>A vertex is pulled to the opposite one: the longer the pull, the stronger the force. The hole is divided into two.</source>
        <translation>将一个顶点拉向对面的顶点：拉得越远，力越大。孔洞被分成两个。</translation>
    </message>
    <message>
        <source>The first button shows the patch of a hole, the second fills the hole with it.</source>
        <translation>第一个按钮显示孔洞的补片，第二个按钮用它填补孔洞。</translation>
    </message>
    <message>
        <source>It is subdivided and dragged at its coarse level; the fine level follows as if on a spring.</source>
        <translation>补片被细分，并在粗层级上拖动；细层级像弹簧一样跟随。</translation>
    </message>
</context>
<context>
    <name>handwheel::RepairJobs</name>
    <message>
        <source>Filling hole %1</source>
        <translation>正在填补孔洞 %1</translation>
    </message>
    <message>
        <source>%1 stays open: %2</source>
        <translation>%1 未填补：%2</translation>
    </message>
    <message>
        <source>Fill hole %1</source>
        <translation>填补孔洞 %1</translation>
    </message>
    <message>
        <source>Filled %1 of %2</source>
        <translation>已填补 %2 的 %1</translation>
    </message>
    <message>
        <source>Repairing %1</source>
        <translation>正在修复 %1</translation>
    </message>
    <message>
        <source>Repair all</source>
        <translation>全部修复</translation>
    </message>
    <message>
        <source>Repaired %1: %2</source>
        <translation>已修复 %1：%2</translation>
    </message>
    <message>
        <source>%1 was changed again; the result was discarded</source>
        <translation>%1 再次更改；结果已丢弃</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Why: %1.</source>
        <translation>原因：%1。</translation>
    </message>
    <message>
        <source>Save your work, and try it on a smaller part or in another way.</source>
        <translation>请保存您的工作，然后在较小的部分上或用其他方法重试。</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1失败</translation>
    </message>
    <message>
        <source>The document is as it was before. %1</source>
        <translation>文档保持原样。%1</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n more pair(s) of triangles intersect; undo reverts this</source>
        <translation>
            <numerusform>%1：新增 %n 对相交的三角形；撤销可恢复</numerusform>
        </translation>
    </message>
    <message>
        <source>A hole opened by the repair</source>
        <translation>修复过程中产生的孔洞</translation>
    </message>
    <message>
        <source>%1 was changed meanwhile; the job runs again</source>
        <translation>%1 在此期间已更改；任务将重新运行</translation>
    </message>
    <message>
        <source>%1: %2 by %3</source>
        <translation>%1：%2，%3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln whole piece(s) deleted</source>
        <translation>
            <numerusform>已删除 %Ln 个完整部分</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <translation>%1：%2：%3</translation>
    </message>
    <message>
        <source>largest distance found between the surface before and after %1</source>
        <translation>表面修复前后的最大距离（测得）%1</translation>
    </message>
    <message>
        <source>Repaired %1: nothing was changed</source>
        <translation>已修复 %1：没有任何更改</translation>
    </message>
    <message>
        <source>Nothing more could be repaired without damage. The list of defects gives the reasons that are known.</source>
        <translation>在不造成损坏的前提下已无法再修复。缺陷列表给出已知的原因。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s) were removed from %1.</source>
        <translation>
            <numerusform>已从 %1 中移除 %Ln 个三角形。</numerusform>
        </translation>
    </message>
    <message>
        <source>Check the patch of %1: %2.</source>
        <translation>请检查 %1 的补片：%2。</translation>
    </message>
    <message>
        <source>walls thinner than a voxel were lost: choose smaller voxels</source>
        <translation>比体素薄的壁已丢失：请选择更小的体素</translation>
    </message>
    <message>
        <source>Open a mesh first.</source>
        <translation>请先打开一个网格。</translation>
    </message>
    <message>
        <source>The mesh is being changed.</source>
        <translation>正在更改网格。</translation>
    </message>
</context>
<context>
    <name>handwheel::ReplayDock</name>
    <message>
        <source>round tool, R %1 mm</source>
        <translation>圆弧刀具，R %1 mm</translation>
    </message>
    <message>
        <source>&amp;Replay</source>
        <translation>回放(&amp;R)</translation>
    </message>
    <message>
        <source>Plays the passes that cut the part, on a time line</source>
        <translation>在时间轴上播放切削该零件的各次走刀</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Preparing the replay</source>
        <translation>正在准备回放</translation>
    </message>
    <message>
        <source>Distance from the axis</source>
        <translation>到轴线的距离</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Pass %1: %2</source>
        <translation>走刀 %1：%2</translation>
    </message>
    <message>
        <source>Pass %1 of %2: %3, at R %4 mm, Z %5 mm</source>
        <translation>走刀 %1/%2：%3，位于 R %4 mm，Z %5 mm</translation>
    </message>
    <message>
        <source>Crash: %1, %2</source>
        <translation>碰撞：%1，%2</translation>
    </message>
    <message>
        <source>Resultant force</source>
        <translation>切削合力</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>电机功率</translation>
    </message>
    <message>
        <source>kW</source>
        <translation>kW</translation>
    </message>
    <message>
        <source>Material left over the target</source>
        <translation>超出目标的余料</translation>
    </message>
    <message>
        <source>Cut too deep</source>
        <translation>切削过深</translation>
    </message>
    <message>
        <source>&amp;Compare with…</source>
        <translation>与其他工件比较(&amp;C)…</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比较对象</translation>
    </message>
    <message>
        <source>Workpieces (%1)</source>
        <translation>工件 (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be compared</source>
        <translation>无法比较 %1</translation>
    </message>
    <message>
        <source>&amp;Leave %1</source>
        <translation>结束与 %1 的比较(&amp;L)</translation>
    </message>
    <message>
        <source>Nothing has been cut yet. Recorded passes can be played here.</source>
        <translation>尚未切削。记录的走刀可在此处回放。</translation>
    </message>
    <message>
        <source>It is not a workpiece that was cut.</source>
        <translation>它不是经过切削的工件。</translation>
    </message>
    <message>
        <source>Showing the replay</source>
        <translation>正在显示回放</translation>
    </message>
    <message>
        <source>threading tool, R %1 mm</source>
        <translation>螺纹刀具，R %1 mm</translation>
    </message>
</context>
<context>
    <name>handwheel::ReshapeActions</name>
    <message>
        <source>Make s&amp;hell…</source>
        <translation>抽壳(&amp;H)…</translation>
    </message>
    <message>
        <source>Leave a wall along the surface</source>
        <translation>沿表面留出一层壁</translation>
    </message>
    <message>
        <source>Move s&amp;urface…</source>
        <translation>偏移表面(&amp;U)…</translation>
    </message>
    <message>
        <source>Move the surface out or in</source>
        <translation>将表面向外或向内偏移</translation>
    </message>
    <message>
        <source>C&amp;ombine…</source>
        <translation>组合(&amp;O)…</translation>
    </message>
    <message>
        <source>Unite with another document or file, subtract it, or keep what both have</source>
        <translation>与另一文档或文件合并、减去它，或保留两者共有的部分</translation>
    </message>
    <message>
        <source>Remove &amp;debris…</source>
        <translation>移除碎片(&amp;D)…</translation>
    </message>
    <message>
        <source>Take small parts away</source>
        <translation>移除小的部分</translation>
    </message>
    <message>
        <source>Close &amp;gaps…</source>
        <translation>封闭间隙(&amp;G)…</translation>
    </message>
    <message>
        <source>Fill gaps, cracks and pits</source>
        <translation>填补间隙、裂缝和凹坑</translation>
    </message>
    <message>
        <source>Smooth &amp;all…</source>
        <translation>全部平滑(&amp;A)…</translation>
    </message>
    <message>
        <source>Take small bumps and dents off</source>
        <translation>去除小的凸起和凹陷</translation>
    </message>
    <message>
        <source>Change &amp;whole volume</source>
        <translation>更改整个体素模型(&amp;W)</translation>
    </message>
    <message>
        <source>Shell, moved surface, combination with another body, debris, gaps, smoothing</source>
        <translation>抽壳、偏移表面、与其他物体组合、碎片、间隙、平滑</translation>
    </message>
    <message>
        <source>The volume cannot be changed like that</source>
        <translation>无法这样更改体素模型</translation>
    </message>
    <message>
        <source>Combine with</source>
        <translation>组合对象</translation>
    </message>
</context>
<context>
    <name>handwheel::ResultTable</name>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Sort by “%1”</source>
        <translation>按“%1”排序</translation>
    </message>
    <message>
        <source>First column of the results</source>
        <translation>结果的第一列</translation>
    </message>
</context>
<context>
    <name>handwheel::RigidPartsHaptics</name>
    <message>
        <source>Preparing to touch</source>
        <translation>正在准备触摸</translation>
    </message>
</context>
<context>
    <name>handwheel::RobotCellUi</name>
    <message>
        <source>Open the sample &amp;robot</source>
        <translation>打开示例机器人(&amp;R)</translation>
    </message>
    <message>
        <source>Open the sample robot arm</source>
        <translation>打开示例机械臂</translation>
    </message>
    <message>
        <source>Robot cell</source>
        <translation>机器人单元</translation>
    </message>
    <message>
        <source>Move &amp;joints by hand</source>
        <translation>手动移动关节(&amp;J)</translation>
    </message>
    <message numerus="yes">
        <source>Robot %1: %Ln joint(s) that move.</source>
        <translation>
            <numerusform>机器人 %1:%Ln 个可动关节。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln joint(s)</source>
        <translation>
            <numerusform>%Ln 个关节</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Cell</source>
        <translation>单元(&amp;C)</translation>
    </message>
    <message>
        <source>Drag the links of the robot, and the bodies beside it</source>
        <translation>拖动机器人的连杆及其旁边的物体</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln body(ies)</source>
        <translation>
            <numerusform>%Ln 个物体</numerusform>
        </translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Type another position in the panel.</source>
        <translation>请在面板中输入其他位置。</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>It is at the position given in its file; everything else is transparent while it is selected.</source>
        <translation>它位于其文件给定的位置；选中时其余部分显示为透明。</translation>
    </message>
    <message>
        <source>Drag a link with the mouse, or the whole arm with Shift. Type angles in the list of joints. Add bodies beside the robot in the panel.</source>
        <translation>用鼠标拖动连杆，或按住 Shift 拖动整个机械臂。在关节列表中输入角度。在面板中添加机器人旁的物体。</translation>
    </message>
    <message>
        <source>%1 is inside another object</source>
        <translation>%1 位于另一个物体内部</translation>
    </message>
    <message>
        <source>Opened %1: robot %2 with %3 and %4</source>
        <translation>已打开 %1：机器人 %2，含 %3 和 %4</translation>
    </message>
    <message numerus="yes">
        <source>%n link(s)</source>
        <translation>
            <numerusform>%n 个连杆</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) that move</source>
        <translation>
            <numerusform>%n 个活动关节</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;New cell with a built-in robot…</source>
        <translation>使用内置机器人新建单元(&amp;N)…</translation>
    </message>
    <message>
        <source>New cell</source>
        <translation>新建单元</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>规划</translation>
    </message>
    <message>
        <source>&amp;Process path along a curve</source>
        <translation>沿曲线的加工路径(&amp;P)</translation>
    </message>
    <message>
        <source>Choose an edge or a section of a part for the robot&apos;s tool to work along</source>
        <translation>选择零件的边或截面，供机器人工具沿其加工</translation>
    </message>
    <message>
        <source>Open the sample robot &amp;cell</source>
        <translation>打开示例机器人单元(&amp;C)</translation>
    </message>
    <message>
        <source>Opens a sample cell. Plan a path from left to right, or lead the robot along an edge by hand.</source>
        <translation>打开示例单元。从左到右规划路径，或手动引导机器人沿边移动。</translation>
    </message>
    <message>
        <source>&amp;Lead the robot by hand</source>
        <translation>手动引导机器人(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Choose the arm&apos;s configuration</source>
        <translation>选择机械臂的位形(&amp;C)</translation>
    </message>
    <message>
        <source>Lay a body &amp;face to face</source>
        <translation>面对面贴放物体(&amp;F)</translation>
    </message>
    <message>
        <source>Lay a body with one of its faces on a face of another</source>
        <translation>将物体以其一个面贴放到另一物体的面上</translation>
    </message>
    <message>
        <source>Place a body or robot with &amp;handles</source>
        <translation>用控制柄放置物体或机器人(&amp;H)</translation>
    </message>
    <message>
        <source>Move and turn the selected body, or the base of the selected robot, along and about axes</source>
        <translation>沿轴移动、绕轴转动所选物体或所选机器人的基座</translation>
    </message>
    <message>
        <source>%1 cannot be moved</source>
        <translation>%1 无法移动</translation>
    </message>
    <message>
        <source>Everything in the cell is measured from the base of its first robot.</source>
        <translation>单元中的一切都以第一个机器人的基座为测量基准。</translation>
    </message>
    <message>
        <source>Move the bodies and the other robots.</source>
        <translation>请移动物体和其他机器人。</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>机器人(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Bodies</source>
        <translation>物体(&amp;B)</translation>
    </message>
    <message>
        <source>P&amp;aths</source>
        <translation>路径(&amp;A)</translation>
    </message>
    <message>
        <source>Verif&amp;ication</source>
        <translation>验证(&amp;I)</translation>
    </message>
    <message>
        <source>Pro&amp;grams</source>
        <translation>程序(&amp;G)</translation>
    </message>
    <message>
        <source>Lead the robot&apos;s tool by hand; the arm follows without collisions</source>
        <translation>手动引导机器人的工具；机械臂随之移动而不发生碰撞</translation>
    </message>
    <message>
        <source>Show all configurations in which the arm reaches a pose of its tool: shoulder, elbow and wrist</source>
        <translation>显示机械臂到达其工具某一位姿的所有位形：肩部、肘部和腕部</translation>
    </message>
    <message>
        <source>Open a robot in front of a block on a table, with a path along its edge</source>
        <translation>打开一个机器人，其前方桌上有方块，并有一条沿其边的路径</translation>
    </message>
    <message>
        <source>Create a cell with a robot of the library, from its manufacturer&apos;s data</source>
        <translation>用库中的机器人新建单元，采用其制造商的数据</translation>
    </message>
    <message>
        <source>C&amp;onfigurations, targets and frames</source>
        <translation>构型、目标和坐标系(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Place it beside the others</source>
        <translation>放到其他物体旁(&amp;P)</translation>
    </message>
    <message>
        <source>Go to where the path was shown</source>
        <translation>移到路径显示的位置</translation>
    </message>
</context>
<context>
    <name>handwheel::RoundTargetDialog</name>
    <message>
        <source>Round the target</source>
        <translation>圆整目标</translation>
    </message>
    <message>
        <source>&amp;Round</source>
        <translation>圆整(&amp;R)</translation>
    </message>
    <message>
        <source>Rounding the target</source>
        <translation>正在圆整目标</translation>
    </message>
    <message>
        <source>A surface of the target changes by %1 at most.</source>
        <translation>目标表面最多变化 %1。</translation>
    </message>
</context>
<context>
    <name>handwheel::RunningAttempt</name>
    <message>
        <source>Lesson</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>It could not be handed in</source>
        <translation>无法提交</translation>
    </message>
    <message>
        <source>The exercise that %1 belongs to cannot be read</source>
        <translation>无法读取 %1 所属的练习</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>提交</translation>
    </message>
    <message>
        <source>Handwheel documents (%1)</source>
        <translation>Handwheel 文档 (%1)</translation>
    </message>
    <message>
        <source>%1 is open, and would be replaced.</source>
        <translation>%1 已打开，将会被替换。</translation>
    </message>
    <message>
        <source>Choose another name for the file.</source>
        <translation>请为文件选择其他名称。</translation>
    </message>
    <message>
        <source>Handing in</source>
        <translation>正在提交</translation>
    </message>
    <message>
        <source>Handed in by %1</source>
        <translation>由 %1 提交</translation>
    </message>
    <message>
        <source>The work is in %1.</source>
        <translation>作业位于 %1。</translation>
    </message>
    <message>
        <source>Give that file to your teacher.</source>
        <translation>请将该文件交给教师。</translation>
    </message>
    <message>
        <source>Preparing the exercise</source>
        <translation>正在准备练习</translation>
    </message>
    <message>
        <source>Checking the steps</source>
        <translation>正在检查步骤</translation>
    </message>
    <message>
        <source>Work on %1</source>
        <translation>%1 的作业</translation>
    </message>
    <message>
        <source>Work of %1 on %2</source>
        <translation>%1 对 %2 的作业</translation>
    </message>
    <message>
        <source>Steps of the exercise, with the buttons to measure and to hand in the work</source>
        <translation>练习步骤，以及测量和提交作业的按钮</translation>
    </message>
    <message>
        <source>Some of it cannot be measured: %1</source>
        <translation>其中有些无法测量：%1</translation>
    </message>
    <message>
        <source>Give that file to your teacher, or go on with the work and hand it in once more.</source>
        <translation>请将该文件交给老师，或继续完成作业后再次提交。</translation>
    </message>
</context>
<context>
    <name>handwheel::ScriptExport</name>
    <message>
        <source>Save s&amp;teps…</source>
        <translation>保存步骤(&amp;T)…</translation>
    </message>
    <message>
        <source>Write what was done to the mesh as a file that “handwheel edit --steps” reads</source>
        <translation>将对网格所做的操作写成“handwheel edit --steps”可读取的文件</translation>
    </message>
    <message>
        <source>Save steps</source>
        <translation>保存步骤</translation>
    </message>
    <message>
        <source>Steps (%1)</source>
        <translation>步骤 (%1)</translation>
    </message>
    <message>
        <source>%1 was not written</source>
        <translation>未写入 %1</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>无法保存 %1</translation>
    </message>
    <message>
        <source>Saved the steps as %1</source>
        <translation>步骤已保存为 %1</translation>
    </message>
    <message>
        <source>There is no file from which the steps reproduce the current state.</source>
        <translation>没有可由这些步骤得到当前状态的文件。</translation>
    </message>
    <message>
        <source>Save the document as *.handwheel, and continue from there.</source>
        <translation>请将文档另存为 *.handwheel，再从那里继续。</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>未作更改。</translation>
    </message>
    <message>
        <source>Open a mesh first.</source>
        <translation>请先打开一个网格。</translation>
    </message>
</context>
<context>
    <name>handwheel::SectionView</name>
    <message>
        <source>Cutting</source>
        <translation>正在剖切</translation>
    </message>
    <message>
        <source>Area (%1)</source>
        <translation>面积 (%1)</translation>
    </message>
</context>
<context>
    <name>handwheel::Segmentation</name>
    <message>
        <source>&amp;Segmentation</source>
        <translation>分割(&amp;S)</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>分割</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>Smoothing the segment</source>
        <translation>正在平滑分割区域</translation>
    </message>
    <message>
        <source>Smooth segment</source>
        <translation>平滑分割区域</translation>
    </message>
    <message>
        <source>Counting parts</source>
        <translation>正在统计部分数量</translation>
    </message>
    <message>
        <source>Choose values</source>
        <translation>选择值</translation>
    </message>
    <message>
        <source>Erase from segment</source>
        <translation>从分割区域擦除</translation>
    </message>
    <message>
        <source>Paint segment</source>
        <translation>涂绘分割区域</translation>
    </message>
    <message>
        <source>Keeping the largest parts</source>
        <translation>正在保留最大的部分</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n largest part(s)</source>
        <translation>
            <numerusform>保留最大的 %n 个部分</numerusform>
        </translation>
    </message>
    <message>
        <source>Growing from the point</source>
        <translation>正在从该点生长</translation>
    </message>
    <message>
        <source>Grow from point</source>
        <translation>从点生长</translation>
    </message>
    <message>
        <source>Making the surface</source>
        <translation>正在生成表面</translation>
    </message>
    <message>
        <source>The surface was not made</source>
        <translation>未生成表面</translation>
    </message>
    <message>
        <source>Make surface</source>
        <translation>生成表面</translation>
    </message>
    <message>
        <source>Choose the material of a scan in its slices</source>
        <translation>在扫描的切片中选择其材料</translation>
    </message>
    <message>
        <source>The point (value %1) is not in the segment. Click a coloured place, or choose a range that includes this value.</source>
        <translation>该点（值 %1）不在分割区域内。请单击着色处，或选择包含此值的范围。</translation>
    </message>
</context>
<context>
    <name>handwheel::SegmentationPanel</name>
    <message>
        <source>Lower end of the range</source>
        <translation>范围的下限</translation>
    </message>
    <message>
        <source>Upper end of the range</source>
        <translation>范围的上限</translation>
    </message>
    <message>
        <source>&amp;Otsu</source>
        <translation>大津法(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Bone</source>
        <translation>骨骼(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Skin</source>
        <translation>皮肤(&amp;S)</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>&amp;Largest part only</source>
        <translation>仅最大的部分(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Keep so many</source>
        <translation>保留此数量(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Remove debris</source>
        <translation>移除碎片(&amp;R)</translation>
    </message>
    <message>
        <source>S&amp;mooth</source>
        <translation>平滑(&amp;M)</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>Cross&amp;hair</source>
        <translation>十字线(&amp;H)</translation>
    </message>
    <message>
        <source>Click to move the crosshair</source>
        <translation>单击以移动十字线</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>涂绘(&amp;P)</translation>
    </message>
    <message>
        <source>Adds to the segment; Ctrl: erases. [ and ]: radius</source>
        <translation>添加到分割区域；Ctrl：擦除。[ 和 ]：半径</translation>
    </message>
    <message>
        <source>&amp;Erase</source>
        <translation>擦除(&amp;E)</translation>
    </message>
    <message>
        <source>Erases from the segment; Ctrl: adds. [ and ]: radius</source>
        <translation>从分割区域擦除；Ctrl：添加。[ 和 ]：半径</translation>
    </message>
    <message>
        <source>&amp;Grow from point</source>
        <translation>从点生长(&amp;G)</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>画笔半径</translation>
    </message>
    <message>
        <source>Ball (&amp;3D)</source>
        <translation>球 (&amp;3D)</translation>
    </message>
    <message>
        <source>In the slices</source>
        <translation>在切片中</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Level of the greys</source>
        <translation>灰度窗位</translation>
    </message>
    <message>
        <source>Width of the greys</source>
        <translation>灰度窗宽</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>灰度</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>窗位</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>窗宽</translation>
    </message>
    <message>
        <source>Edge of a voxel</source>
        <translation>体素的边长</translation>
    </message>
    <message>
        <source>Smooth &amp;it</source>
        <translation>使其平滑(&amp;I)</translation>
    </message>
    <message>
        <source>Make s&amp;urface</source>
        <translation>生成表面(&amp;U)</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Voxel</source>
        <translation>体素边长</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s), %1 mm³; the largest is %2 % of it</source>
        <translation>
            <numerusform>%n 个部分，%1 mm³；最大的占其 %2 %</numerusform>
        </translation>
    </message>
    <message>
        <source>Counting parts…</source>
        <translation>正在统计部分数量…</translation>
    </message>
    <message>
        <source>Value %1 at x %2, y %3, z %4 mm</source>
        <translation>x %2、y %3、z %4 mm 处的值为 %1</translation>
    </message>
    <message>
        <source>Below %1 mm³: %2 of %3 parts, %4 mm³</source>
        <translation>小于 %1 mm³：%3 个部分中的 %2 个，%4 mm³</translation>
    </message>
    <message>
        <source>From Otsu&apos;s threshold upwards, which best separates the values into two classes</source>
        <translation>从大津阈值起，该阈值将值最佳地分为两类</translation>
    </message>
    <message>
        <source>300 Hounsfield units and above</source>
        <translation>300 亨氏单位及以上</translation>
    </message>
    <message>
        <source>-200 Hounsfield units and above: everything except air</source>
        <translation>-200 亨氏单位及以上：除空气外的一切</translation>
    </message>
    <message>
        <source>Keeps only the largest connected part</source>
        <translation>仅保留最大的相连部分</translation>
    </message>
    <message>
        <source>Number of largest parts to keep</source>
        <translation>要保留的最大部分的数量</translation>
    </message>
    <message>
        <source>Keeps this number of the largest parts</source>
        <translation>保留此数量的最大部分</translation>
    </message>
    <message>
        <source>Volume below which parts are debris</source>
        <translation>体积小于此值的部分视为碎片</translation>
    </message>
    <message>
        <source>Removes all parts smaller than this</source>
        <translation>移除所有小于此值的部分</translation>
    </message>
    <message>
        <source>Removes specks and smooths steps: each sample follows the majority of its 3 × 3 × 3 neighbourhood</source>
        <translation>移除斑点并平滑台阶：每个采样点取其 3 × 3 × 3 邻域中的多数</translation>
    </message>
    <message>
        <source>Click a point of the segment: only the part connected to it is kept</source>
        <translation>单击分割区域中的一点：仅保留与其相连的部分</translation>
    </message>
    <message>
        <source>The brush is a ball that reaches into neighbouring slices; otherwise it paints in one slice</source>
        <translation>画笔为球形，延伸到相邻的切片；否则只在一个切片中涂绘</translation>
    </message>
    <message>
        <source>Smooths the voxel steps of the surface</source>
        <translation>平滑表面的体素台阶</translation>
    </message>
    <message>
        <source>Creates the volume of the segment, which can be shaped, drilled and saved; undo restores the previous one</source>
        <translation>生成分割区域的体素模型，可进行塑造、钻孔和保存；撤销可恢复之前的体素模型</translation>
    </message>
    <message>
        <source>Edited by hand: choosing another range discards these edits (undo restores them).</source>
        <translation>已手动编辑：选择其他范围会丢弃这些编辑（撤销可恢复）。</translation>
    </message>
    <message>
        <source>No sample has a value in this range.</source>
        <translation>没有采样点的值处于此范围内。</translation>
    </message>
    <message>
        <source>About %1 MB of %2 MB available</source>
        <translation>约 %1 MB，可用 %2 MB</translation>
    </message>
    <message>
        <source>Larger voxels need less.</source>
        <translation>体素越大，所需内存越少。</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>The region of the image that is taken</source>
        <translation>所取的图像区域</translation>
    </message>
    <message>
        <source>Patient&apos;s left at the le&amp;ft</source>
        <translation>患者左侧在左边(&amp;F)</translation>
    </message>
    <message>
        <source>Shows slices as seen from the head and from the back; otherwise the patient&apos;s right is at the left, as radiologists have it</source>
        <translation>按从头部和背部看的方式显示切片；否则患者右侧在左边，与放射科惯例一致</translation>
    </message>
    <message>
        <source>All labels</source>
        <translation>所有标签</translation>
    </message>
    <message>
        <source>The volume was made from an earlier segment.</source>
        <translation>该体积由先前的分割生成。</translation>
    </message>
</context>
<context>
    <name>handwheel::SelfIntersectionSearch</name>
    <message>
        <source>Searching self-intersections</source>
        <translation>正在查找自相交</translation>
    </message>
</context>
<context>
    <name>handwheel::ServiceModel</name>
    <message>
        <source>%1 % of the frame</source>
        <translation>占帧时间的 %1 %</translation>
    </message>
    <message>
        <source>%1 % of the servo tick</source>
        <translation>占伺服周期的 %1 %</translation>
    </message>
    <message>
        <source>running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>服务</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Ticks/s</source>
        <translation>周期/秒</translation>
    </message>
    <message>
        <source>µs per tick</source>
        <translation>µs/周期</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>占比</translation>
    </message>
    <message>
        <source>too slow by %1 %</source>
        <translation>慢 %1 %</translation>
    </message>
    <message numerus="yes">
        <source>%n input(s) dropped</source>
        <translation>
            <numerusform>丢失 %n 个输入</numerusform>
        </translation>
    </message>
    <message>
        <source>idle</source>
        <translation>空闲</translation>
    </message>
</context>
<context>
    <name>handwheel::SessionDevicePanel</name>
    <message>
        <source>along (Z)</source>
        <translation>轴向 (Z)</translation>
    </message>
    <message>
        <source>radius (X)</source>
        <translation>径向 (X)</translation>
    </message>
    <message>
        <source>across</source>
        <translation>切向</translation>
    </message>
</context>
<context>
    <name>handwheel::ShellActions</name>
    <message>
        <source>Split into s&amp;hells</source>
        <translation>拆分为壳体(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Add a mesh…</source>
        <translation>添加网格(&amp;A)…</translation>
    </message>
    <message numerus="yes">
        <source>Split into %Ln shell(s)</source>
        <translation>
            <numerusform>已拆分为 %Ln 个壳体</numerusform>
        </translation>
    </message>
    <message>
        <source>The mesh is one shell</source>
        <translation>该网格是一个整体壳体</translation>
    </message>
    <message numerus="yes">
        <source>There are %Ln shell(s)</source>
        <translation>
            <numerusform>共有 %Ln 个壳体</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a mesh</source>
        <translation>添加网格</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>%1 could not be added</source>
        <translation>无法添加 %1</translation>
    </message>
    <message>
        <source>The shells could not be opened</source>
        <translation>无法打开壳体</translation>
    </message>
    <message>
        <source>Open each shell (triangles connected across edges) as a separate document</source>
        <translation>将每个壳体（通过边相连的三角形）作为单独的文档打开</translation>
    </message>
    <message>
        <source>Add the mesh of another file to this one, at its own position</source>
        <translation>将另一文件的网格按其自身位置添加到此网格</translation>
    </message>
    <message>
        <source>“handwheel split” writes that many into a folder. Debris can be removed first.</source>
        <translation>“handwheel split”可将这么多壳体写入文件夹。可先移除碎片。</translation>
    </message>
</context>
<context>
    <name>handwheel::ShortcutEditor</name>
    <message>
        <source>No key</source>
        <translation>无按键</translation>
    </message>
    <message>
        <source>The command has no key any more</source>
        <translation>该命令不再有按键</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>The other commands lose this key</source>
        <translation>其他命令将失去此按键</translation>
    </message>
    <message>
        <source>Search by name or key</source>
        <translation>按名称或按键搜索</translation>
    </message>
    <message>
        <source>Search commands and keys</source>
        <translation>搜索命令和按键</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>命令及其按键</translation>
    </message>
    <message>
        <source>New key of the chosen command</source>
        <translation>所选命令的新按键</translation>
    </message>
    <message>
        <source>Press the new key here</source>
        <translation>在此按下新按键</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>全部重置</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>导入…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Write the changed keys to a file</source>
        <translation>将更改的按键写入文件</translation>
    </message>
    <message>
        <source>Choose a command to change its key.</source>
        <translation>选择命令以更改其按键。</translation>
    </message>
    <message>
        <source>”, “</source>
        <translation>”、“</translation>
    </message>
    <message>
        <source>Import keys</source>
        <translation>导入按键</translation>
    </message>
    <message>
        <source>Keys (*.json)</source>
        <translation>按键 (*.json)</translation>
    </message>
    <message>
        <source>Export keys</source>
        <translation>导出按键</translation>
    </message>
    <message>
        <source>Restore the default key</source>
        <translation>恢复默认按键</translation>
    </message>
    <message>
        <source>Reassign</source>
        <translation>重新分配</translation>
    </message>
    <message>
        <source>Restore all default keys</source>
        <translation>恢复所有默认按键</translation>
    </message>
    <message>
        <source>Read the keys from a file</source>
        <translation>从文件读取按键</translation>
    </message>
    <message>
        <source>“%1” has the same key, so neither works.</source>
        <translation>“%1”使用相同的按键，因此两者都无效。</translation>
    </message>
    <message>
        <source>“%1” has the same key. In the view, the key acts on the active tool.</source>
        <translation>“%1”使用相同的按键。在视图中，该按键作用于当前工具。</translation>
    </message>
    <message>
        <source>The keys were imported.</source>
        <translation>已导入按键。</translation>
    </message>
    <message>
        <source>The changed keys were exported.</source>
        <translation>已导出更改的按键。</translation>
    </message>
</context>
<context>
    <name>handwheel::ShortcutModel</name>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Return, Enter and Esc end what a tool does. No other command can have them.</source>
        <translation>Return、Enter 和 Esc 用于结束工具的操作，不能分配给其他命令。</translation>
    </message>
    <message>
        <source>In every tool Return finishes and Esc cancels: these keys cannot be changed.</source>
        <translation>在所有工具中，Return 完成操作，Esc 取消操作：这些按键无法更改。</translation>
    </message>
    <message>
        <source>This key does not exist.</source>
        <translation>没有这样的按键。</translation>
    </message>
    <message>
        <source>In a tool, a shortcut must be a single key press.</source>
        <translation>在工具中，快捷键只能是一次按键。</translation>
    </message>
</context>
<context>
    <name>handwheel::SimulationBanner</name>
    <message>
        <source>Simulated – not cut yet</source>
        <translation>仿真结果 – 尚未切削</translation>
    </message>
    <message>
        <source>&amp;Cut the work</source>
        <translation>切削工件(&amp;C)</translation>
    </message>
    <message>
        <source>The view shows what the program would cut. The document, and what is saved, is the part before it.</source>
        <translation>视图显示程序将切削的结果。文档以及保存的内容仍是切削之前的零件。</translation>
    </message>
    <message>
        <source>Show the part as it is</source>
        <translation>显示零件的当前状态</translation>
    </message>
    <message>
        <source>Leave the simulation; the program stays as it is</source>
        <translation>退出仿真；程序保持不变</translation>
    </message>
</context>
<context>
    <name>handwheel::SlicesPanel</name>
    <message>
        <source>Axial</source>
        <translation>轴状位</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>冠状位</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>矢状位</translation>
    </message>
    <message>
        <source>Wheel, Page up and down: slices. Right button: level and width of the greys. Ctrl+wheel, + and -: zoom; middle button: move. Shift+click, arrows: crosshair. Space: the chosen tool there.</source>
        <translation>滚轮、Page Up 和 Page Down：切片。右键：灰度的窗位和窗宽。Ctrl+滚轮、+ 和 -：缩放；中键：移动。Shift+单击、方向键：十字线。空格：在该处使用所选工具。</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>%1切片</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 / %3</translation>
    </message>
</context>
<context>
    <name>handwheel::SlowdownLabel</name>
    <message>
        <source>The computer does not keep up. Nothing is left out: the simulation runs slower than the clock.</source>
        <translation>计算机跟不上。没有省略任何内容：仿真比时钟运行得慢。</translation>
    </message>
    <message>
        <source>Simulation at %1 % of real time</source>
        <translation>仿真速度为实时的 %1 %</translation>
    </message>
</context>
<context>
    <name>handwheel::SpaceMouseNavigation</name>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
</context>
<context>
    <name>handwheel::StampAction</name>
    <message>
        <source>Load s&amp;tamp…</source>
        <translation>加载印章(&amp;T)…</translation>
    </message>
    <message>
        <source>Shape clay by the brightness of a picture, or by the height of a part</source>
        <translation>按图片的亮度或零件的高度塑造黏土</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.pgm *.ppm *.pbm)</source>
        <translation>图片 (*.png *.jpg *.jpeg *.bmp *.gif *.pgm *.ppm *.pbm)</translation>
    </message>
    <message>
        <source>Load a stamp</source>
        <translation>加载印章</translation>
    </message>
    <message>
        <source>Loading a stamp</source>
        <translation>正在加载印章</translation>
    </message>
    <message>
        <source>The stamp cannot be loaded</source>
        <translation>无法加载印章</translation>
    </message>
</context>
<context>
    <name>handwheel::StartPage</name>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>打开文件…</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近的文件</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Clear the list of recent files</source>
        <translation>清空最近文件列表</translation>
    </message>
    <message>
        <source>Or drop files anywhere on this window</source>
        <translation>或将文件拖放到窗口任意处</translation>
    </message>
    <message>
        <source>The sample is not installed.</source>
        <translation>示例未安装。</translation>
    </message>
    <message>
        <source>Repair scans, shape clay, practise at lathe and drill, arrange robot cells.</source>
        <translation>修复扫描、塑造黏土、练习车削和钻孔、布置机器人单元。</translation>
    </message>
</context>
<context>
    <name>handwheel::StateCard</name>
    <message>
        <source>Watertight</source>
        <translation>水密</translation>
    </message>
    <message numerus="yes">
        <source>%Ln hole(s)</source>
        <translation>
            <numerusform>%Ln 个孔洞</numerusform>
        </translation>
    </message>
    <message>
        <source>Not manifold</source>
        <translation>非流形</translation>
    </message>
    <message>
        <source>Not oriented</source>
        <translation>方向不一致</translation>
    </message>
    <message>
        <source>Self-intersecting</source>
        <translation>自相交</translation>
    </message>
    <message>
        <source>Inside out</source>
        <translation>内外翻转</translation>
    </message>
    <message numerus="yes">
        <source>%Ln reversed on opening</source>
        <translation>
            <numerusform>打开时反转了 %Ln 个</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln open sheet(s)</source>
        <translation>
            <numerusform>%Ln 个开放片体</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln hole(s) kept open</source>
        <translation>
            <numerusform>%Ln 个孔保持开放</numerusform>
        </translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>没有孔</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>封闭</translation>
    </message>
    <message>
        <source>self-intersections not known yet</source>
        <translation>尚不清楚是否自相交</translation>
    </message>
    <message>
        <source>Inconsistently oriented</source>
        <translation>方向不一致</translation>
    </message>
</context>
<context>
    <name>handwheel::StatusPanel</name>
    <message>
        <source>Services</source>
        <translation>服务</translation>
    </message>
</context>
<context>
    <name>handwheel::SubmissionsView</name>
    <message>
        <source>&amp;Mark…</source>
        <translation>评分(&amp;M)…</translation>
    </message>
    <message>
        <source>Mark files that students have handed in</source>
        <translation>对学生提交的文件评分</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>报告(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Table…</source>
        <translation>表格(&amp;T)…</translation>
    </message>
    <message>
        <source>Submissions</source>
        <translation>提交的作业</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>比较(&amp;C)…</translation>
    </message>
    <message>
        <source>Write a report of the two selected works side by side (Ctrl+click selects a second one)</source>
        <translation>将两份所选作业写成对照报告（Ctrl+单击可选择第二份）</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>移除(&amp;V)</translation>
    </message>
    <message>
        <source>Remove the selected works from the class; their files stay</source>
        <translation>从班级中移除所选作业；其文件保留</translation>
    </message>
</context>
<context>
    <name>handwheel::SuggestedTextRow</name>
    <message>
        <source>Choose from a list</source>
        <translation>从列表中选择</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>选择：%1</translation>
    </message>
</context>
<context>
    <name>handwheel::SuggestionCard</name>
    <message>
        <source>Do not show this card for this document again</source>
        <translation>不再为此文档显示此卡片</translation>
    </message>
    <message>
        <source>Show the details and all actions</source>
        <translation>显示详情和所有操作</translation>
    </message>
    <message>
        <source>Fold this card to one line</source>
        <translation>将此卡片折叠为一行</translation>
    </message>
</context>
<context>
    <name>handwheel::TargetActions</name>
    <message>
        <source>Import &amp;target…</source>
        <translation>导入目标(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Remove target</source>
        <translation>移除目标(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Deviation in colours</source>
        <translation>以颜色显示偏差(&amp;D)</translation>
    </message>
    <message>
        <source>Show where the part is larger or smaller than the target</source>
        <translation>显示零件比目标大或小的位置</translation>
    </message>
    <message>
        <source>Remove target</source>
        <translation>移除目标</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>Import a target</source>
        <translation>导入目标</translation>
    </message>
    <message>
        <source>Turned parts (%1)</source>
        <translation>车削件 (%1)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>Import target</source>
        <translation>导入目标</translation>
    </message>
    <message>
        <source>Target read from %1</source>
        <translation>已从 %1 读取目标</translation>
    </message>
    <message>
        <source>&amp;Target in the view</source>
        <translation>在视图中显示目标(&amp;T)</translation>
    </message>
    <message>
        <source>Rou&amp;ghness in colours</source>
        <translation>以颜色显示粗糙度(&amp;G)</translation>
    </message>
    <message>
        <source>Show the outline of the target over the part</source>
        <translation>在零件上显示目标的轮廓线</translation>
    </message>
    <message>
        <source>Show how rough the part is, from feed and nose of its last cuts</source>
        <translation>显示零件的粗糙程度，由其最后几次切削的进给和刀尖圆弧得出</translation>
    </message>
    <message>
        <source>Target of the exercise</source>
        <translation>练习的目标</translation>
    </message>
    <message>
        <source>Where the target lies</source>
        <translation>目标的位置</translation>
    </message>
    <message>
        <source>The finished face of the part is zero of the drawing and of programs. The bar goes beyond it by what is left for facing. It can be changed later in the panel Stock.</source>
        <translation>零件的完工端面是图纸和程序的零点。棒料超出该端面的部分即端面余量。以后可在“毛坯”面板中更改。</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>导入(&amp;I)</translation>
    </message>
    <message>
        <source>blue: Ra %1 µm or less, white: %2, red: %3 or more, grey: unknown</source>
        <translation>蓝：Ra 不大于 %1 µm，白：%2，红：不小于 %3，灰：未知</translation>
    </message>
    <message>
        <source>Import the target shape of the part from STEP, DXF, SVG or a workpiece</source>
        <translation>从 STEP、DXF、SVG 或工件导入零件的目标形状</translation>
    </message>
    <message>
        <source>Do not compare the part with a target</source>
        <translation>不将零件与目标比较</translation>
    </message>
    <message>
        <source>%1 cannot be used as a target</source>
        <translation>%1 不能用作目标</translation>
    </message>
    <message>
        <source>Turn the target &amp;end for end</source>
        <translation>将目标掉头(&amp;E)</translation>
    </message>
    <message>
        <source>Make the end at the chuck the free one, whose face is finished</source>
        <translation>使卡盘一端成为自由端，其端面为已加工面</translation>
    </message>
    <message>
        <source>Turn the target end for end</source>
        <translation>将目标掉头</translation>
    </message>
    <message>
        <source>The target is that of the exercise.</source>
        <translation>目标由练习给定。</translation>
    </message>
    <message>
        <source>Open a workpiece first.</source>
        <translation>请先打开一个工件。</translation>
    </message>
    <message>
        <source>There is no target.</source>
        <translation>没有目标。</translation>
    </message>
</context>
<context>
    <name>handwheel::TargetPanel</name>
    <message>
        <source>Bore %1</source>
        <translation>孔 %1</translation>
    </message>
    <message>
        <source>Measured dimensions</source>
        <translation>测得的尺寸</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Dimensions</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>No target: import one to compare the part with it.</source>
        <translation>没有目标：请导入一个目标与零件比较。</translation>
    </message>
    <message>
        <source>Too large by up to %1</source>
        <translation>最多偏大 %1</translation>
    </message>
    <message>
        <source>Too small by up to %1</source>
        <translation>最多偏小 %1</translation>
    </message>
    <message>
        <source>blue: %1 too small, red: %1 too large</source>
        <translation>蓝色：偏小 %1，红色：偏大 %1</translation>
    </message>
    <message>
        <source>Curve ⌀ %1 … %2</source>
        <translation>曲线 ⌀ %1 … %2</translation>
    </message>
</context>
<context>
    <name>handwheel::TargetPlacementView</name>
    <message>
        <source>The target in its bar; the free end is on the right</source>
        <translation>棒料中的目标；自由端在右侧</translation>
    </message>
    <message>
        <source>Grey: the target. Blue: what is cut off the bar</source>
        <translation>灰色：目标。蓝色：从棒料上切除的部分</translation>
    </message>
    <message>
        <source>← chuck</source>
        <translation>← 卡盘</translation>
    </message>
    <message>
        <source>Turn &amp;end for end</source>
        <translation>首尾调转(&amp;E)</translation>
    </message>
    <message>
        <source>Make the end at the chuck the free one, whose face is finished</source>
        <translation>将卡盘端变为自由端，其端面需加工</translation>
    </message>
    <message>
        <source>free end →</source>
        <translation>自由端 →</translation>
    </message>
</context>
<context>
    <name>handwheel::ThreadAction</name>
    <message>
        <source>T&amp;hread…</source>
        <translation>螺纹(&amp;H)…</translation>
    </message>
    <message>
        <source>Cut a thread outside or in a bore, between two heights</source>
        <translation>在两个高度之间车削外螺纹或内螺纹</translation>
    </message>
    <message>
        <source>Cutting the thread</source>
        <translation>正在切削螺纹</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>螺纹</translation>
    </message>
    <message>
        <source>The exercise does not allow it: cut the thread on the lathe, by its half-nut.</source>
        <translation>练习不允许：请在车床上用开合螺母车削螺纹。</translation>
    </message>
    <message>
        <source>Open a workpiece first.</source>
        <translation>请先打开一个工件。</translation>
    </message>
</context>
<context>
    <name>handwheel::ThreadDialog</name>
    <message>
        <source>Thread</source>
        <translation>螺纹</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>切削(&amp;C)</translation>
    </message>
    <message>
        <source>ISO metric profile: the bottom of the groove is at a diameter of %1.</source>
        <translation>ISO 公制牙型：牙槽底部直径为 %1。</translation>
    </message>
    <message>
        <source>The bottom of the groove is at a diameter of %1.</source>
        <translation>牙槽底部直径为 %1。</translation>
    </message>
</context>
<context>
    <name>handwheel::TickTiming</name>
    <message>
        <source>Servo tick in use: %1 of %2 µs (%3 %)</source>
        <translation>伺服节拍占用：%2 µs 中的 %1 µs（%3 %）</translation>
    </message>
    <message>
        <source>Predicted while touching: %1 µs</source>
        <translation>触碰时的预测：%1 µs</translation>
    </message>
    <message>
        <source>While touching: %1 µs, predicted %2 µs (%3 %)</source>
        <translation>触碰时：%1 µs，预测 %2 µs（%3 %）</translation>
    </message>
</context>
<context>
    <name>handwheel::TimeLinePanel</name>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>上一个事件</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>下一个事件</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>按时间</translation>
    </message>
    <message>
        <source>Over distance</source>
        <translation>按距离</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>No recording</source>
        <translation>没有录制</translation>
    </message>
    <message>
        <source>Two recordings</source>
        <translation>两个录制</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 / %2 s</translation>
    </message>
    <message>
        <source>, %1 mm</source>
        <translation>，%1 mm</translation>
    </message>
</context>
<context>
    <name>handwheel::TimeTrack</name>
    <message>
        <source>Time line</source>
        <translation>时间轴</translation>
    </message>
</context>
<context>
    <name>handwheel::TimingPage</name>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>Nothing was measured yet.</source>
        <translation>还没有测量数据。</translation>
    </message>
    <message>
        <source>Half within %1, 99 % within %2, some above %3</source>
        <translation>一半在 %1 以内，99 % 在 %2 以内，个别超过 %3</translation>
    </message>
    <message>
        <source>Half within %1, 99 % within %2, all within %3</source>
        <translation>一半在 %1 以内，99 % 在 %2 以内，全部在 %3 以内</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>显示内容</translation>
    </message>
    <message>
        <source>From tick to tick</source>
        <translation>节拍间隔</translation>
    </message>
    <message>
        <source>How late a tick comes</source>
        <translation>节拍迟到多少</translation>
    </message>
    <message>
        <source>Time spent in a tick</source>
        <translation>每个节拍耗时</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>The servo loop is not running.</source>
        <translation>伺服循环没有运行。</translation>
    </message>
    <message>
        <source>%1 ticks a second, %2 missed so far</source>
        <translation>每秒 %1 个节拍，到目前为止漏掉 %2 个</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolCamera</name>
    <message>
        <source>&amp;View from the tool</source>
        <translation>从工具观察(&amp;V)</translation>
    </message>
    <message>
        <source>Look from the tool&apos;s centre point along its axis; the view moves with the robot</source>
        <translation>从工具中心点沿其轴线观察；视图随机器人移动</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolHost</name>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>move the tip in and out</source>
        <translation>前后移动尖端</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+滚轮</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>缩放</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolKeys</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolPanel</name>
    <message>
        <source>This tool has no settings.</source>
        <translation>此工具没有设置。</translation>
    </message>
    <message>
        <source>Not now: %1.</source>
        <translation>暂不可用：%1。</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolPostRow</name>
    <message>
        <source>Tool in the post</source>
        <translation>刀架上的刀具</translation>
    </message>
    <message>
        <source>&amp;Mount</source>
        <translation>安装(&amp;M)</translation>
    </message>
    <message>
        <source>Mounts another tool on this side of the post, or a drill in the tailstock</source>
        <translation>在刀架的这一侧安装另一把刀具，或在尾座中安装钻头</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1, in the tailstock</source>
        <translation>%1，在尾座中</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>无刀具</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolTableDialog</name>
    <message>
        <source>Tools of the program</source>
        <translation>程序的刀具</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Nose radius</source>
        <translation>刀尖圆弧半径</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>刀尖方位</translation>
    </message>
    <message>
        <source>Offset X</source>
        <translation>X 偏置</translation>
    </message>
    <message>
        <source>Offset Z</source>
        <translation>Z 偏置</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>From the &amp;lathe</source>
        <translation>取自车床(&amp;L)</translation>
    </message>
    <message>
        <source>A nose alone</source>
        <translation>仅刀尖</translation>
    </message>
    <message>
        <source>The tools with the T numbers of the program. With a tool of the lathe, its holder, the tool post and the slide are checked for collisions, too. Tools that are not listed have the nose radius of the panel.</source>
        <translation>程序中各 T 编号对应的刀具。对于车床上的刀具，还会检查其刀杆、刀架和拖板的碰撞。未列出的刀具采用面板中的刀尖圆弧半径。</translation>
    </message>
    <message>
        <source>Upside down</source>
        <translation>翻转安装</translation>
    </message>
    <message>
        <source>The insert faces the other side than those of the machine do: it cuts with the other of M3 and M4.</source>
        <translation>刀片的朝向与机床的其他刀片相反：使用 M3 和 M4 中的另一个进行切削。</translation>
    </message>
</context>
<context>
    <name>handwheel::TouchPage</name>
    <message>
        <source>&amp;Snap the device</source>
        <translation>捕捉设备(&amp;S)</translation>
    </message>
    <message>
        <source>Attract the tip of the device to what a click of the active tool would choose</source>
        <translation>将设备尖端吸引到当前工具点击时会选取的对象</translation>
    </message>
</context>
<context>
    <name>handwheel::ViewActions</name>
    <message>
        <source>&amp;Fit</source>
        <translation>适合窗口(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>深色主题(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>等轴测(&amp;I)</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>前视(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>后视(&amp;B)</translation>
    </message>
    <message>
        <source>Rig&amp;ht</source>
        <translation>右视(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左视(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>俯视(&amp;T)</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>仰视(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation>着色(&amp;S)</translation>
    </message>
    <message>
        <source>Shaded with &amp;edges</source>
        <translation>带边着色(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>线框(&amp;W)</translation>
    </message>
    <message>
        <source>Switch between the light and the dark theme</source>
        <translation>切换浅色与深色主题</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>显示整个模型</translation>
    </message>
    <message>
        <source>Look from: %1</source>
        <translation>视向:%1</translation>
    </message>
    <message>
        <source>L&amp;athe</source>
        <translation>车床(&amp;A)</translation>
    </message>
</context>
<context>
    <name>handwheel::ViewCube</name>
    <message>
        <source>View cube</source>
        <translation>视图立方体</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Front of the patient (A)</source>
        <translation>患者前侧（A）</translation>
    </message>
    <message>
        <source>Back of the patient (P)</source>
        <translation>患者后侧（P）</translation>
    </message>
    <message>
        <source>Right of the patient (R)</source>
        <translation>患者右侧（R）</translation>
    </message>
    <message>
        <source>Left of the patient (L)</source>
        <translation>患者左侧（L）</translation>
    </message>
    <message>
        <source>Feet of the patient (F)</source>
        <translation>患者足侧（F）</translation>
    </message>
    <message>
        <source>Head of the patient (H)</source>
        <translation>患者头侧（H）</translation>
    </message>
</context>
<context>
    <name>handwheel::ViewSettings</name>
    <message>
        <source>Perspective inste&amp;ad of parallel</source>
        <translation>以透视代替平行投影(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;View cube</source>
        <translation>视图立方体(&amp;V)</translation>
    </message>
    <message>
        <source>What is farther away looks smaller</source>
        <translation>较远的物体看起来较小</translation>
    </message>
    <message>
        <source>The cube in the corner that turns the view</source>
        <translation>角落里用于旋转视图的立方体</translation>
    </message>
    <message>
        <source>&amp;Clip the model</source>
        <translation>剖切模型(&amp;C)</translation>
    </message>
    <message>
        <source>Clip the model by a plane to look inside; the panel “View” positions the plane</source>
        <translation>用平面剖切模型以查看内部；可在“视图”面板中设置平面位置</translation>
    </message>
    <message>
        <source>&amp;Half section</source>
        <translation>半剖视图(&amp;H)</translation>
    </message>
    <message>
        <source>Cut the part through its axis, seen from here, to look into its bores</source>
        <translation>沿轴线（从当前视角）剖开零件，以查看其内孔</translation>
    </message>
    <message>
        <source>Only turned parts have an axis.</source>
        <translation>只有车削件有轴线。</translation>
    </message>
</context>
<context>
    <name>handwheel::Viewport</name>
    <message>
        <source>3D view</source>
        <translation>三维视图</translation>
    </message>
    <message>
        <source>The 3D view needs an X server, and this session runs on “%1”. Start the program in an X11 session, or in a Wayland session with Xwayland.</source>
        <translation>三维视图需要 X 服务器，而当前会话运行于“%1”。请在 X11 会话或带 Xwayland 的 Wayland 会话中启动程序。</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.2 through an X server (GLX), which this session does not offer. Start the program in an X11 session, or in a Wayland session with Xwayland.</source>
        <translation>三维视图需要通过 X 服务器（GLX）使用 OpenGL 3.2，当前会话不提供。请在 X11 会话或带 Xwayland 的 Wayland 会话中启动程序。</translation>
    </message>
    <message>
        <source>The 3D view could not start: the display offers no OpenGL. Check the graphics driver, or whether the X server provides GLX.</source>
        <translation>三维视图无法启动：显示环境不提供 OpenGL。请检查显卡驱动，或 X 服务器是否提供 GLX。</translation>
    </message>
    <message>
        <source>There is not enough memory to draw all of the model.</source>
        <translation>内存不足，无法绘制整个模型。</translation>
    </message>
</context>
<context>
    <name>handwheel::VolumeUi</name>
    <message>
        <source>Volume</source>
        <translation>体素模型</translation>
    </message>
    <message>
        <source>%1 mm³ in voxels of %2 mm. Its surface is closed.</source>
        <translation>%1 mm³，体素边长 %2 mm。其表面是封闭的。</translation>
    </message>
    <message>
        <source>Opened %1: a volume</source>
        <translation>已打开 %1：体素模型</translation>
    </message>
    <message>
        <source>&amp;Volume</source>
        <translation>体素模型(&amp;O)</translation>
    </message>
    <message>
        <source>New &amp;clay</source>
        <translation>新建黏土(&amp;C)</translation>
    </message>
    <message>
        <source>Start with a ball of clay to be shaped by hand</source>
        <translation>从一个可手动塑造的黏土球开始</translation>
    </message>
    <message>
        <source>Shape &amp;clay</source>
        <translation>塑造黏土(&amp;C)</translation>
    </message>
    <message>
        <source>Add, carve, smooth and move clay by hand</source>
        <translation>手动添加、挖去、平滑和移动黏土</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>New &amp;skull</source>
        <translation>新建颅骨(&amp;S)</translation>
    </message>
    <message>
        <source>Making the skull</source>
        <translation>正在生成颅骨</translation>
    </message>
    <message>
        <source>Shape clay</source>
        <translation>塑造黏土</translation>
    </message>
    <message>
        <source>Starts with a ball of clay. Add, carve and smooth it by hand.</source>
        <translation>从一个黏土球开始。手动添加、挖去和平滑黏土。</translation>
    </message>
    <message>
        <source>Start with a synthetic skull to be drilled, not that of a patient</source>
        <translation>从一个可供钻孔的合成颅骨开始，并非取自患者</translation>
    </message>
    <message>
        <source>This volume is to be drilled, not shaped</source>
        <translation>此体素模型用于钻孔，而非塑形</translation>
    </message>
    <message>
        <source>It is work on an exercise, which measures what the drill takes and nothing else.</source>
        <translation>它是练习的作业，练习只测量钻头切除的部分。</translation>
    </message>
    <message>
        <source>Choose Drill (Shift+D).</source>
        <translation>请选择“钻孔”(Shift+D)。</translation>
    </message>
</context>
<context>
    <name>handwheel::VoxelizeQuestion</name>
    <message>
        <source>Make a volume</source>
        <translation>创建体积</translation>
    </message>
    <message>
        <source>The volume becomes a document of its own. Whatever is smaller than a voxel is lost.</source>
        <translation>体积将成为独立文档。小于体素的细节会丢失。</translation>
    </message>
    <message>
        <source>&amp;Make volume</source>
        <translation>创建体积(&amp;M)</translation>
    </message>
    <message>
        <source>%1 voxels along the largest extent: %2</source>
        <translation>沿最大尺寸 %1 个体素：%2</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>约 %1 s</translation>
    </message>
    <message>
        <source>by the resolution rule of drilling, at 1 mm/s and 1 kHz</source>
        <translation>按钻削分辨率规则，1 mm/s、1 kHz</translation>
    </message>
    <message>
        <source>four to the thickness of a wall</source>
        <translation>每个壁厚四个</translation>
    </message>
    <message>
        <source>as chosen</source>
        <translation>按所选</translation>
    </message>
    <message>
        <source>Measuring %1</source>
        <translation>正在测量 %1</translation>
    </message>
    <message>
        <source>%1 was not copied</source>
        <translation>未复制 %1</translation>
    </message>
    <message>
        <source>256 to the largest extent</source>
        <translation>最大尺寸上 256 个</translation>
    </message>
</context>
<context>
    <name>handwheel::WorkpieceUi</name>
    <message>
        <source>Opened %1: stock %2</source>
        <translation>已打开 %1：毛坯 %2</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>&amp;Workpiece</source>
        <translation>工件(&amp;W)</translation>
    </message>
    <message>
        <source>Stock of %1.</source>
        <translation>毛坯 %1。</translation>
    </message>
    <message>
        <source>&amp;New workpiece</source>
        <translation>新建工件(&amp;N)</translation>
    </message>
    <message>
        <source>Start with a cylinder to be turned</source>
        <translation>从待车削的圆柱开始</translation>
    </message>
    <message>
        <source>Open the sample s&amp;haft</source>
        <translation>打开示例轴(&amp;H)</translation>
    </message>
    <message>
        <source>Open the sample shaft for the lathe</source>
        <translation>打开用于车床的示例轴</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>车削(&amp;T)</translation>
    </message>
    <message>
        <source>Cut the turning part by hand with a round tool</source>
        <translation>用圆头刀具手动切削旋转的工件</translation>
    </message>
    <message>
        <source>It was cut already, so its size is fixed. “Save as” writes STEP, too.</source>
        <translation>它已被切削，尺寸固定。“另存为”也可写入 STEP。</translation>
    </message>
    <message>
        <source>Undo the passes to change the size.</source>
        <translation>请撤销走刀以更改尺寸。</translation>
    </message>
    <message>
        <source>It was cut already, so its size is fixed.</source>
        <translation>它已被切削，因此尺寸已固定。</translation>
    </message>
    <message>
        <source>Turn a sample bar</source>
        <translation>车削示例棒料</translation>
    </message>
    <message>
        <source>Opens a sample bar. Cut it to a shaft by hand, save it as STEP.</source>
        <translation>打开示例棒料。手动将其车削成轴，并保存为 STEP。</translation>
    </message>
    <message>
        <source>&amp;Lathe</source>
        <translation>车床(&amp;L)</translation>
    </message>
    <message>
        <source>Work the part on a manual lathe with handwheels and levers</source>
        <translation>在带手轮和操纵杆的手动车床上加工工件</translation>
    </message>
    <message>
        <source>Too fast</source>
        <translation>过快</translation>
    </message>
    <message>
        <source>The feed of this pass was up to %1 mm per revolution; at most %2 is allowed.</source>
        <translation>此次走刀的进给最大达每转 %1 mm；最大允许 %2。</translation>
    </message>
    <message>
        <source>Undo it, and drag more slowly: f at the pointer is the feed.</source>
        <translation>请撤销，并放慢拖动：指针处的 f 即进给。</translation>
    </message>
    <message>
        <source>The bar is that of the exercise.</source>
        <translation>棒料由练习规定。</translation>
    </message>
    <message>
        <source>It is the bar of the exercise. The panel “Lesson” says what to do; “Turn” and “Lathe” cut it.</source>
        <translation>棒料由练习规定。“课程”面板说明该做什么；用“车削”和“车床”进行切削。</translation>
    </message>
    <message>
        <source>Checking force and power</source>
        <translation>正在检查切削力和功率</translation>
    </message>
    <message>
        <source>The motor power of this pass was up to %1 kW; the lathe of the exercise has %2 kW.</source>
        <translation>此次走刀的电机功率最大达 %1 kW；练习所用车床为 %2 kW。</translation>
    </message>
    <message>
        <source>Too heavy a cut</source>
        <translation>切削过重</translation>
    </message>
    <message>
        <source>%1 is a program for a lathe</source>
        <translation>%1 是车床程序</translation>
    </message>
    <message>
        <source>A program is opened in the program editor of the workpiece that it turns.</source>
        <translation>程序在其所车削工件的程序编辑器中打开。</translation>
    </message>
    <message>
        <source>Open that workpiece first, then the program, or open the program on a new bar.</source>
        <translation>请先打开该工件，再打开程序，或在新棒料上打开程序。</translation>
    </message>
    <message>
        <source>Open on a new bar</source>
        <translation>在新棒料上打开</translation>
    </message>
    <message>
        <source>Programs (%1)</source>
        <translation>程序 (%1)</translation>
    </message>
    <message>
        <source>The resultant force of this pass was up to %1 N; the lathe of the exercise allows %2 N.</source>
        <translation>此次走刀的切削合力最大达 %1 N；练习所用车床允许 %2 N。</translation>
    </message>
    <message>
        <source>Enter another size in its panel, also as “2in” or “50/2”. “Save as” writes STEP, too.</source>
        <translation>可在其面板中输入其他尺寸，也可写作“2in”或“50/2”。“另存为”也能写 STEP。</translation>
    </message>
    <message>
        <source>It is in the report, and lowers the marks. Undo it, and use a smaller depth or feed.</source>
        <translation>它会写入报告并降低得分。请撤消，并减小切深或进给。</translation>
    </message>
    <message>
        <source>It is in the report. Undo it, and use a smaller depth or feed.</source>
        <translation>它会写入报告。请撤消，并减小切深或进给。</translation>
    </message>
    <message>
        <source>Parted off</source>
        <translation>已切断</translation>
    </message>
    <message>
        <source>A piece of %1 mm length has come off at the free end.</source>
        <translation>自由端已切下一段长 %1 毫米的工件。</translation>
    </message>
    <message>
        <source>Its volume is %1 mm³; %2 mm³ stay in the chuck. Dimensions and exported drawings and STEP files are those of the piece.</source>
        <translation>其体积为 %1 mm³；%2 mm³ 留在卡盘中。尺寸及导出的图纸和 STEP 文件均为该段的。</translation>
    </message>
    <message>
        <source>A piece of %1 mm length has come off.</source>
        <translation>已切下一段长 %1 毫米的工件。</translation>
    </message>
    <message>
        <source>Its volume is %1 mm³; %2 mm³ stay in the chuck. Dimensions and exported drawings and STEP files are still those of the piece at the free end, which came off before.</source>
        <translation>其体积为 %1 mm³；卡盘中留有 %2 mm³。尺寸以及导出的图纸和 STEP 文件仍是先前从自由端切下的那一段的。</translation>
    </message>
    <message>
        <source>Measuring the part</source>
        <translation>正在测量零件</translation>
    </message>
</context>
</TS>
